// Several rays through a pixel: the mean, its points, and its encoding.

#include "common/render/pixel_samples.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/picture.hpp"

#include <cmath>

using namespace rt;

namespace {

/// A single pixel that sees a square of side 2 at the distance 1, of which a blue triangle covers
/// everything on one side of a line. With Shading::normal its color is (0, 0, 1).
Image covered(Vec3 on_line, Vec3 along, const RenderSettings& settings) {
    Scene scene{.resolution = {.width = 1, .height = 1}, .cameras = {Camera{}}};
    scene.cameras.front().fov = 2 * std::atan(Real(1));
    const Vec3 beside = cross(Vec3(0, 0, 1), along);
    scene.triangles = {{.shape = {.a = on_line - Real(64) * along,
                                  .b = on_line + Real(64) * along,
                                  .c = on_line + Real(64) * beside},
                        .material = {}}};
    return render(scene, {.settings = settings})->image;
}

}  // namespace

TEST_CASE("a pixel has the color of the share that a shape covers") {
    // N points, N a power of 4, have one in each of N columns, and one in each of N rows.
    for (const int count : {4, 16, 64, 256, 1024}) {
        const RenderSettings settings{.shading = Shading::normal, .pixel_samples = count};
        for (int sixteenths = 0; sixteenths <= 16; ++sixteenths) {
            if (sixteenths * count % 16 != 0) continue;
            const Real edge = Real(sixteenths) / 8 - 1;
            const auto blue = std::uint8_t(255 * sixteenths / 16.0 + 0.5);
            const Image from_left = covered({edge, 0, -1}, {0, 1, 0}, settings);
            const Image from_right = covered({-edge, 0, -1}, {0, -1, 0}, settings);
            const Image from_below = covered({0, edge, -1}, {-1, 0, 0}, settings);
            for (const Image& image : {from_left, from_right, from_below})
                CHECK(image.pixels.front() == Rgb{0, 0, blue});
        }
    }
    const RenderSettings one{.shading = Shading::normal};
    CHECK(covered({Real(0.1), 0, -1}, {0, 1, 0}, one).pixels.front() == Rgb{0, 0, 255});
    CHECK(covered({Real(-0.1), 0, -1}, {0, 1, 0}, one).pixels.front() == Rgb{0, 0, 0});
}

TEST_CASE("the mean is encoded, not the rays' colors") {
    const RenderSettings settings{
        .shading = Shading::normal, .gamma = Gamma::srgb, .pixel_samples = 4};
    CHECK(covered({0, 0, -1}, {0, 1, 0}, settings).pixels.front() == Rgb{0, 0, 188});
}

TEST_CASE("light is encoded as IEC 61966-2-1 does") {
    CHECK(to_rgb({0, Real(0.0031308), 1}, Gamma::srgb) == Rgb{0, 10, 255});
    CHECK(to_rgb({Real(0.001), Real(0.18), Real(0.5)}, Gamma::srgb) == Rgb{3, 118, 188});
    CHECK(to_rgb({-1, 2, infinity}, Gamma::srgb) == Rgb{0, 255, 255});
    CHECK(to_rgb({0, NAN, 0}, Gamma::srgb) == not_a_color);
    for (const Gamma gamma : {Gamma::unstated, Gamma::linear})
        CHECK(to_rgb({Real(0.25), Real(0.5), 3}, gamma) == Rgb{64, 128, 255});
}

TEST_CASE("with several rays too, the picture is the same for any number of threads") {
    Scene scene = load_scene(project_file("scenes/cornell_box.rt"), orthonormal_basis);
    scene.resolution = {.width = 31, .height = 17};
    const RenderSettings settings{.pixel_samples = 5};
    const auto alone = render(scene, {.threads = 1, .settings = settings});
    CHECK(alone->rays == 5 * 31 * 17);
    for (const int threads : {2, 3, 40})
        CHECK(render(scene, {.threads = threads, .settings = settings})->image.pixels ==
              alone->image.pixels);
}

TEST_CASE("each ray through a pixel counts as what can be shown of it, and NaN as NaN") {
    // Left of the middle one ray sees 5 times white, right of it none sees anything.
    Scene scene{.resolution = {.width = 1, .height = 1}, .cameras = {Camera{}}};
    for (const Real part : {Real(5), Real(NAN)}) {
        scene.triangles = {{.shape = {.a = {0, -64, -1}, .b = {0, 64, -1}, .c = {-64, 0, -1}},
                            .material = {Color(part, 0, 0)}}};
        const auto rendering = render(scene, {.settings = {.pixel_samples = 16}});
        CHECK(rendering->not_a_number == (std::isnan(part) ? 1 : 0));
        CHECK(rendering->image.pixels.front() == (std::isnan(part) ? not_a_color : Rgb{128, 0, 0}));
    }
}

TEST_CASE("finer pixels lie in their pixel, and both precisions have the same") {
    for (const Pixel pixel : {Pixel{0, 0}, {3, 5}, {8191, 8191}}) {
        const Pixel first = FinerRays::at(pixel, {0, 0});
        const Pixel next = FinerRays::at({pixel.row + 1, pixel.column + 1}, {0, 0});
        const Real most = std::nextafter(Real(1), Real(0));
        const Pixel last = FinerRays::at(pixel, {most, most});
        CHECK((last.row == next.row - 1 && last.column == next.column - 1));
        CHECK((first.row < last.row && first.column < last.column));
        // The center of a finer pixel, in halves of its side, is exact in float.
        CHECK(int(float(2 * last.column + 1)) == 2 * last.column + 1);
    }
}

TEST_CASE("the rays of a pixel share the rays to a light, and their error") {
    const RenderSettings one{.shadow_samples = 16, .shadow_error = 2, .shadow_agree = 8};
    RenderSettings many = one;
    many.pixel_samples = 16;
    const RenderSettings each = shared_settings(many);
    CHECK(each.shadow_samples == 4);
    CHECK(each.shadow_agree == 2);
    CHECK(each.shadow_error == 8);
    CHECK(shared_settings(one).shadow_samples == 16);
    many.shadow_samples = 1;
    CHECK(shared_settings(many).shadow_samples == 1);
    many.shadow_agree = 0;
    CHECK(shared_settings(many).shadow_agree == 0);
}

TEST_CASE("adaptive sampling starts with rays whose number rises in small steps") {
    CHECK(first_pixel_samples(32) == 8);
    CHECK(first_pixel_samples(4) == 8);
    CHECK(first_pixel_samples(3.9) == 10);
    CHECK(first_pixel_samples(3) == 12);
    CHECK(first_pixel_samples(2.1) == 16);
    CHECK(first_pixel_samples(2) == 16);
    CHECK(first_pixel_samples(1) == 32);
    CHECK(first_pixel_samples(0.01) == 128);
    for (double error = 8; error > 0.1; error *= 0.99) {
        const int count = first_pixel_samples(error);
        CHECK((count == 128 || count * error >= 32));
        CHECK((count == 8 || count * error <= 32 * 1.25));
    }
}

TEST_CASE("adaptive sampling goes on from a picture of one ray a pixel") {
    Scene scene = load_scene(project_file("scenes/one_sphere.rt"), orthonormal_basis);
    scene.resolution = {.width = 80, .height = 60};
    for (const RenderJob& job : {RenderJob{.settings = {.pixel_samples = 256, .pixel_error = 4}},
                                 RenderJob{.threads = 2, .settings = {}}}) {
        auto centers = render_centers(scene, job);
        REQUIRE(centers);
        CHECK(centers->rays == 80 * 60);
        RenderJob second = job;
        second.centers = &*centers;
        const auto whole = render(scene, job);
        const auto begun = render(scene, second);
        CHECK(begun->image.pixels == whole->image.pixels);
        CHECK(begun->rays == whole->rays);
        CHECK(begun->not_a_number == whole->not_a_number);
    }
    Rendering black{.image = Image(scene.resolution)};
    const RenderJob from_black{.settings = {.pixel_samples = 256, .pixel_error = 4},
                               .centers = &black};
    CHECK(render(scene, from_black)->rays == 0);  // a picture without an edge
}

TEST_CASE("adaptive sampling: only edges get more rays, and any number of threads the same") {
    Scene scene = load_scene(project_file("scenes/one_sphere.rt"), orthonormal_basis);
    scene.resolution = {.width = 80, .height = 60};
    const RenderSettings many{.pixel_samples = 256};
    const RenderSettings adaptive{.pixel_samples = 256, .pixel_error = 4};
    const auto exact = render(scene, {.settings = many});
    const auto alone = render(scene, {.threads = 1, .settings = adaptive});
    CHECK(alone->rays < exact->rays / 16);
    for (const int threads : {2, 7}) {
        const auto rendering = render(scene, {.threads = threads, .settings = adaptive});
        CHECK(rendering->image.pixels == alone->image.pixels);
        CHECK(rendering->rays == alone->rays);
    }
    const auto squares = [&exact](const Image& image) {
        double sum = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            sum += std::pow(image.pixels[i][0] - exact->image.pixels[i][0], 2);
        return sum / double(image.pixels.size());
    };
    CHECK(squares(alone->image) < squares(render(scene, {})->image) / 4);
}

TEST_CASE("adaptive sampling: a picture without an edge has one ray for each pixel") {
    Scene scene{.resolution = {.width = 9, .height = 7}, .cameras = {Camera{}}};
    const RenderSettings adaptive{.pixel_samples = 64, .pixel_error = 1};
    CHECK(render(scene, {.settings = adaptive})->rays == 9 * 7);
}

TEST_CASE("adaptive sampling: a line of half a pixel is followed where all centers miss it") {
    // From one side of the picture to the other it climbs by less than half a pixel.
    Scene scene{.resolution = {.width = 64, .height = 8}, .cameras = {Camera{}}};
    scene.cameras.front().fov = 2 * std::atan(Real(1));
    const Real pixel = Real(2) / 8;
    const Real left = -9;
    const Real right = 9;
    const Vec3 a(left, Real(-0.05) * pixel, -1);
    const Vec3 b(right, Real(0.35) * pixel, -1);
    const Vec3 up(0, pixel / 2, 0);
    scene.triangles = {{.shape = {.a = a, .b = b, .c = b + up}, .material = {}},
                       {.shape = {.a = a, .b = b + up, .c = a + up}, .material = {}}};
    const RenderSettings one{.shading = Shading::normal};
    const RenderSettings adaptive{
        .shading = Shading::normal, .pixel_samples = 256, .pixel_error = 4};
    int hits = 0;
    int followed = 0;
    const Image centers = render(scene, {.settings = one})->image;
    const Image image = render(scene, {.settings = adaptive})->image;
    for (Pixel place{.row = 3}; place.column < 64; ++place.column) {
        hits += centers[place][2] > 0;
        followed += image[place][2] > 255 / 8;
    }
    CHECK((0 < hits && hits < 64));
    CHECK(followed == 64);
}

TEST_CASE("adaptive sampling: a pixel that is not a number is counted once") {
    Scene scene{.resolution = {.width = 8, .height = 6}, .cameras = {Camera{}}};
    scene.triangles = {{.shape = {.a = {0, -64, -1}, .b = {0, 64, -1}, .c = {-64, 0, -1}},
                        .material = {Color(NAN, 0, 0)}}};
    const RenderSettings adaptive{.pixel_samples = 16, .pixel_error = 1};
    const auto rendering = render(scene, {.settings = adaptive});
    CHECK(rendering->not_a_number == 4 * 6);
    CHECK(rendering->first_not_a_number.column == 0);
}
