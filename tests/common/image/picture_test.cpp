// From a scene to a picture: colors, the render loop, the picture in a terminal.

#include "common/image/preview.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>

using namespace rt;

namespace {

Image noisy_image(Resolution size) {
    Random random(7);
    Image image(size);
    for (Rgb& pixel : image.pixels)
        for (std::uint8_t& part : pixel) part = static_cast<std::uint8_t>(random.below(256));
    return image;
}

Scene cornell_box(Resolution size) {
    Scene scene = load_scene(project_file("scenes/cornell_box.rt"), orthonormal_basis);
    scene.resolution = size;
    return scene;
}

int lines(const std::string& text) {
    return int(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("a color is rounded to the nearest of 256, and clamped at both ends") {
    for (int part = 0; part <= 255; ++part) {
        const auto byte = static_cast<std::uint8_t>(part);
        CHECK(to_rgb(Color(Real(part) / 255)) == Rgb{byte, byte, byte});
    }
    CHECK(to_rgb({Real(0.25) / 255, Real(0.75) / 255, Real(254.4) / 255}) == Rgb{0, 1, 254});
    CHECK(to_rgb({Real(0.5), Real(-0.0), 1}) == Rgb{128, 0, 255});
    CHECK(to_rgb({Real(1.001), -1, 2}) == Rgb{255, 0, 255});
    CHECK(to_rgb({infinity, -infinity, std::numeric_limits<Real>::max()}) == Rgb{255, 0, 255});
}

TEST_CASE("a color with a part that is not a number is magenta") {
    for (int part = 0; part < 3; ++part) {
        Color color(0);
        color[part] = NAN;
        CHECK(to_rgb(color) == not_a_color);
    }
}

TEST_CASE("the picture is the same for any number of threads, more than rows too") {
    const Scene scene = cornell_box({.width = 61, .height = 37});
    const Image image = render(scene, {.threads = 1})->image;
    CHECK(image.resolution.width == 61);
    CHECK(image.pixels.size() == 61 * 37);
    for (const int threads : {2, 3, 7, 40}) {
        const auto rendering = render(scene, {.threads = threads});
        CHECK(rendering->image.pixels == image.pixels);
        CHECK(rendering->rays == 61 * 37);
    }
    CHECK(render(cornell_box({1, 1}), {.threads = 2})->rays == 1);
}

TEST_CASE("each row is reported once") {
    std::atomic<int> rows = 0;
    const Scene scene = cornell_box({.width = 5, .height = 33});
    CHECK(render(scene, {.threads = 3, .row_done = [&rows] { ++rows; }}));
    CHECK(rows == 33);
}

TEST_CASE("a picture that is stopped, before or during the rendering, is discarded") {
    const Scene scene = cornell_box({.width = 20, .height = 200});
    std::atomic<bool> stop = true;
    std::atomic<int> rows = 0;
    const auto row_done = [&] { stop = ++rows >= 10; };
    CHECK_FALSE(render(scene, {.threads = 2, .row_done = row_done, .stop = &stop}));
    CHECK(rows == 0);
    stop = false;
    CHECK_FALSE(render(scene, {.threads = 2, .row_done = row_done, .stop = &stop}));
    CHECK(rows < 20);
    stop = false;
    CHECK(render(scene, {.threads = 2, .stop = &stop}));
}

TEST_CASE("pixels that are not a number are counted, and the topmost is named") {
    // All around the camera, so that every pixel shows it.
    const Sphere around{.center = {0, 0, 0}, .radius = 9};
    Scene scene{.resolution = {.width = 8, .height = 6}, .cameras = {Camera{}}};
    scene.spheres = {{.shape = around, .material = {Color(1, NAN, 1)}}};
    // Nearer, to the left and above.
    scene.planes = {{.shape = {.point = {-1, 0, 0}, .normal = {1, 0, 0}}, .material = {}}};
    for (const int threads : {1, 3}) {
        const auto rendering = render(scene, {.threads = threads});
        std::int64_t magenta = 0;
        Pixel first{.row = -1};
        for (Pixel pixel; pixel.row < 6; ++pixel.row)
            for (pixel.column = 0; pixel.column < 8; ++pixel.column)
                if (rendering->image[pixel] == not_a_color && magenta++ == 0) first = pixel;
        CHECK(0 < magenta);
        CHECK(magenta < 48);
        CHECK(rendering->not_a_number == magenta);
        CHECK(rendering->first_not_a_number.row == first.row);
        CHECK(rendering->first_not_a_number.column == first.column);
    }
    CHECK(render(scene, {.settings = {.shading = Shading::normal}})->not_a_number == 0);
}

TEST_CASE("the picture in the terminal: two pixels a character, upper and lower") {
    Image image(Resolution{2, 2});
    image[{0, 0}] = {1, 2, 3};
    image[{1, 0}] = {4, 5, 6};
    image[{1, 1}] = {255, 255, 255};
    CHECK(preview(image, 80) ==
          "\033[38;2;1;2;3m\033[48;2;4;5;6m▀"
          "\033[38;2;0;0;0m\033[48;2;255;255;255m▀\033[0m\n");
}

TEST_CASE("the picture in the terminal is no wider than that, and keeps its shape") {
    Image image(Resolution{640, 480});
    std::fill(image.pixels.begin(), image.pixels.end(), Rgb{10, 20, 30});
    const std::string text = preview(image, 40);
    CHECK(lines(text) == 15);  // 40 x 30 pixels
    const std::string character = "\033[38;2;10;20;30m\033[48;2;10;20;30m▀";
    std::string line;
    for (int i = 0; i < 40; ++i) line += character;
    CHECK(text.substr(0, text.find('\n')) == line + "\033[0m");
    CHECK(lines(preview(image, 1)) == 1);
}

TEST_CASE("a picture of one pixel, one row or one column is seen in the terminal too") {
    CHECK(lines(preview(noisy_image({1, 1}), 80)) == 1);
    CHECK(lines(preview(noisy_image({8192, 1}), 80)) == 1);
    CHECK(lines(preview(noisy_image({8192, 2}), 80)) == 1);
    CHECK(lines(preview(noisy_image({3, 3}), 80)) == 1);
    CHECK(lines(preview(noisy_image({1, 4}), 80)) == 2);
}
