// The numbers of --shade, the records of rays, and the colors.

#include "common/render/pixel_values.hpp"
#include "common/image/color_scale.hpp"

#include "tests/kit/for_all.hpp"

#include <cmath>
#include <set>

using namespace rt;

namespace {

/// Seen from the origin, along −z: a picture of 3 × 3 pixels, in whose middle is the axis.
Scene seen() {
    Scene scene{.resolution = {.width = 3, .height = 3}, .cameras = {Camera{}}};
    scene.cameras.front().fov = 2 * std::atan(Real(1));
    return scene;
}

/// The number in the middle of the picture, or in the corner at the upper left.
std::optional<float> number(const Scene& scene, RenderSettings settings, bool in_corner = false) {
    const auto values = pixel_values(scene, {.threads = 2, .settings = settings});
    return values->numbers[in_corner ? 0 : 4];
}

/// Proportional to light.
double luminance(Rgb color) {
    const auto light = [](double byte) {
        const double value = byte / 255;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * light(color[0]) + 0.7152 * light(color[1]) + 0.0722 * light(color[2]);
}

}  // namespace

TEST_CASE("depth is a distance, and t is that of the ray") {
    Scene scene = seen();
    scene.planes = {{.shape = {.point = {0, 0, -6}, .normal = {0, 0, 1}}, .material = {}}};
    CHECK(number(scene, {.shading = Shading::depth}) == 6);
    CHECK(number(scene, {.shading = Shading::t}) == 6);  // stage 1's d_r is (x, y, −1)
    // The corner's pixel is at (−2/3, 2/3) on the screen.
    CHECK(number(scene, {.shading = Shading::t}, true) == 6);
    CHECK(std::abs(*number(scene, {.shading = Shading::depth}, true) - 6 * std::sqrt(17.0) / 3) <
          1e-5);
    scene.planes = {{.shape = {.point = {0, 0, 6}, .normal = {0, 0, 1}}, .material = {}}};
    for (const Shading shading : {Shading::depth, Shading::t, Shading::id, Shading::bounces})
        CHECK_FALSE(number(scene, {.shading = shading}));
    CHECK(number(scene, {.shading = Shading::cost}) == 1);
}

TEST_CASE("id counts all shapes, in the order of their kinds") {
    Scene scene = seen();
    scene.spheres = {{.shape = {.center = {0, 9, -5}}, .material = {}},
                     {.shape = {.center = {0, 0, -5}}, .material = {}}};
    scene.planes = {{.shape = {.point = {0, 0, -6}, .normal = {0, 0, 1}}, .material = {}}};
    CHECK(number(scene, {.shading = Shading::id}) == 1);
    CHECK(number(scene, {.shading = Shading::id}, true) == 2);
    CHECK(name_of_shape(1, scene) == "sphere 2");
    CHECK(name_of_shape(2, scene) == "plane 1");
    CHECK(number(scene, {.shading = Shading::cost}) == 3);
    CHECK_FALSE(number_of(nullptr, scene));
    // With a hierarchy, the same shape for fewer tests.
    for (int i = 0; i < 100; ++i)
        scene.spheres.push_back({.shape = {.center = {3 * i, 30, -5}}, .material = {}});
    CHECK(number(scene, {.shading = Shading::cost}) == 103);
    build_acceleration(scene);
    CHECK(number(scene, {.shading = Shading::id}) == 1);
    CHECK(*number(scene, {.shading = Shading::cost}) < 10);
}

TEST_CASE("between two mirrors, a ray is reflected until --depth") {
    Scene scene = seen();
    const Material mirror{.mirror = 1};
    scene.planes = {{.shape = {.point = {0, 0, -2}, .normal = {0, 0, 1}}, .material = mirror},
                    {.shape = {.point = {0, 0, 2}, .normal = {0, 0, 1}}, .material = mirror}};
    for (const int depth : {0, 1, 5})
        CHECK(number(scene, {.shading = Shading::bounces, .depth = depth}) == float(depth));
    // Each of the rays is tested against both planes.
    CHECK(number(scene, {.shading = Shading::cost, .depth = 5}) == 12);
    scene.planes = {{.shape = {.point = {0, 0, -2}, .normal = {0, 0, 1}}, .material = {}}};
    CHECK(number(scene, {.shading = Shading::bounces}) == 0);
}

TEST_CASE("the records of a pixel's rays have what they hit, and what blocks a light") {
    Scene scene = seen();
    scene.planes = {{.shape = {.point = {0, 0, -4}, .normal = {0, 0, 1}}, .material = {}}};
    scene.spheres = {{.shape = {.center = {0, 2, -2}, .radius = Real(0.5)}, .material = {}}};
    scene.lights = {{.position = {0, 4, 0}}, {.position = {0, -4, 0}}};
    const Ray ray{.origin = Vec3(0), .direction = {0, 0, -1}};
    const RayRecords records = trace_records(scene, ray, {});
    REQUIRE(records.rays.size() == 3);
    const RayRecord& eye = records.rays[0];
    CHECK(eye.kind == RayKind::eye);
    CHECK(eye.t == 4);
    CHECK(eye.point == Numbers{0, 0, -4});
    CHECK(eye.normal == Numbers{0, 0, 1});
    CHECK(number_of(eye.shape, scene) == 1);
    const RayRecord& blocked = records.rays[1];
    CHECK(blocked.kind == RayKind::shadow);
    CHECK(number_of(blocked.shape, scene) == 0);
    // It enters the ball after all of its way but the half behind the center and the radius.
    const double length = std::hypot(blocked.direction[1], blocked.direction[2]);
    REQUIRE(blocked.t);
    CHECK(std::abs(*blocked.t * length - (std::sqrt(8.0) - 0.5)) < 1e-4);
    CHECK(records.rays[2].kind == RayKind::shadow);
    CHECK(records.rays[2].shape == nullptr);
    CHECK_FALSE(records.rays[2].t);
}

TEST_CASE("samples are those of --pixel-error: many beside an edge, one elsewhere") {
    Scene scene = seen();
    scene.resolution = {.width = 9, .height = 1};
    scene.triangles = {
        {.shape = {.a = {Real(-0.1), -64, -1}, .b = {Real(-0.1), 64, -1}, .c = {64, 0, -1}},
         .material = {}}};
    scene.ambient = Ambient{.ratio = 1};
    const RenderSettings settings{
        .shading = Shading::samples, .pixel_samples = 64, .pixel_error = 4};
    const auto values = pixel_values(scene, {.settings = settings});
    CHECK(values->numbers.front() == 1);
    CHECK(values->numbers.back() == 1);
    float most = 0;
    for (const auto& count : values->numbers) most = std::max(most, *count);
    CHECK(most >= 8);
}

TEST_CASE("a scale of colors is ordered by lightness, and none of its colors is black") {
    CHECK(luminance(scale_color(0)) > 0.01);
    for (int i = 0; i < 255; ++i)
        CHECK(luminance(scale_color(i / 255.0)) < luminance(scale_color((i + 1) / 255.0)));
    CHECK(scale_color(-1) == scale_color(0));
    CHECK(scale_color(2) == scale_color(1));
    CHECK(scale_color(std::nan("")) == scale_color(0));
    std::set<Rgb> colors;
    for (int i = 0; i < 200; ++i) colors.insert(distinct_color(i));
    CHECK(colors.size() == 200);
}
