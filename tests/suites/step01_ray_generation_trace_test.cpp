// Stage 1, `render`: the loop over the pixels, on small pictures, against MRT §1 and M1 ("bilan").
#include "common/contract/rendered.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/inverse_matrices.hpp"
#include "tests/kit/picture.hpp"

using namespace rt;

namespace {

constexpr Real right_angle = pi / 2;  // tan(FOV / 2) = 1

std::string size_text(Resolution size) {
    return "{.width = " + std::to_string(size.width) +
           ", .height = " + std::to_string(size.height) + "}";
}

/// The direction through the pixel's center as a color, of 255: each coordinate from −1 to 1.
Rgb expected_color(Pixel pixel, Resolution size, Real fov) {
    const Exact side = 2 * std::tan(Exact(fov) / 2) / size.height;
    const Exact x = (pixel.column + Exact(0.5) - Exact(size.width) / 2) * side;
    const Exact y = (Exact(size.height) / 2 - pixel.row - Exact(0.5)) * side;
    const Exact length = std::sqrt(x * x + y * y + 1);
    const auto level = [length](Exact coordinate) {
        return std::uint8_t(std::lround((coordinate / length + 1) / 2 * 255));
    };
    return {level(x), level(y), level(-1)};
}

/// Every pixel has the color of its direction, to 1 of 255.
Verdict render_shows_directions(Resolution size, Real fov) {
    Scene scene;
    scene.resolution = size;
    scene.cameras = {{.fov = fov}};
    const Image image = rendered(scene);
    int different = 0;
    std::string first;
    for (Pixel pixel; pixel.row < size.height; ++pixel.row) {
        for (pixel.column = 0; pixel.column < size.width; ++pixel.column) {
            const Rgb expected = expected_color(pixel, size, fov);
            if (fits(image[pixel], expected, {0, 0, 0}) || different++ > 0) continue;
            first = "\n  first:    row " + std::to_string(pixel.row) + ", column " +
                    std::to_string(pixel.column) + "\n  got:      " + text(image[pixel]) +
                    "\n  expected: " + text(expected);
        }
    }
    return verdict(different == 0, "render(" + size_text(size) + ", " + code(fov) + "): of " +
                                       std::to_string(size.width * size.height) + " pixels " +
                                       std::to_string(different) + " differ" + first);
}

}  // namespace

TEST_CASE("a picture of one pixel shows the ray through its center (MRT §1)", "[part render]") {
    CHECK(render_shows_directions({.width = 1, .height = 1}, right_angle));
}

TEST_CASE("in a picture of one row, each column has its own ray (MRT §1, j)") {
    CHECK(render_shows_directions({.width = 2, .height = 1}, right_angle));
    CHECK(render_shows_directions({.width = 7, .height = 1}, right_angle));
}

TEST_CASE("in a picture of one column, each row has its own ray (MRT §1, i)") {
    CHECK(render_shows_directions({.width = 1, .height = 2}, right_angle));
    CHECK(render_shows_directions({.width = 1, .height = 7}, right_angle));
}

TEST_CASE("every pixel of a square picture has its own ray (M1)") {
    CHECK(render_shows_directions({.width = 3, .height = 3}, right_angle));
}

TEST_CASE("every pixel of a picture wider than high has its own ray (M1)") {
    CHECK(render_shows_directions({.width = 5, .height = 3}, right_angle));
}

TEST_CASE("every pixel of a picture higher than wide has its own ray (M1)") {
    CHECK(render_shows_directions({.width = 3, .height = 5}, right_angle));
}

TEST_CASE("the field of view is the one that is given (MRT §1)") {
    CHECK(render_shows_directions({.width = 4, .height = 3}, pi / 6));
    CHECK(render_shows_directions({.width = 4, .height = 3}, 2 * pi / 3));
}

TEST_CASE("pictures of any size (MRT §1, M1)") {
    const auto shows_directions = [](Random& random) {
        const Resolution size{.width = 1 + random.below(24), .height = 1 + random.below(24)};
        return render_shows_directions(size, random.between(Real(0.5), Real(2.5)));
    };
    CHECK(for_all(shows_directions, 30));
}

TEST_CASE("the picture of the stage, by this loop (MRT §1)") {
    CHECK(picture_matches("step01_ray_generation"));
}
