// Stage 1 against MRT §1 and M1.
#include "steps/step01_ray_generation/ray_generation.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/inverse_matrices.hpp"
#include "tests/kit/picture.hpp"

using namespace rt;

namespace {

constexpr Real right_angle = pi / 2;  // tan(FOV / 2) = 1
constexpr Resolution vga{.width = 640, .height = 480};
constexpr Resolution three{.width = 3, .height = 3};
constexpr Real two_thirds = Real(2) / 3;

std::string arguments(Pixel pixel, Resolution resolution, Real fov) {
    return "({.row = " + std::to_string(pixel.row) + ", .column = " + std::to_string(pixel.column) +
           "}, {.width = " + std::to_string(resolution.width) +
           ", .height = " + std::to_string(resolution.height) + "}, " + code(fov) + ")";
}

Verdict on_screen(Pixel pixel, Resolution resolution, Real fov, Vec2 expected) {
    return gives("pixel_on_screen" + arguments(pixel, resolution, fov),
                 pixel_on_screen(pixel, resolution, fov), expected);
}

/// Pixels are squares of side 2 tan(FOV / 2) / H around the middle of the screen.
Vec2 center_of(Pixel pixel, Resolution resolution, Real fov) {
    const Exact side = 2 * std::tan(Exact(fov) / 2) / resolution.height;
    return {Real((pixel.column + Exact(0.5) - Exact(resolution.width) / 2) * side),
            Real((Exact(resolution.height) / 2 - pixel.row - Exact(0.5)) * side)};
}

/// OpenGL's view of the world from there, along −z.
Mat4 view_from(Vec3 position) {
    return glm::translate(Mat4(1), -position);
}

/// A camera at (1, 2, 3) of nine pixels, with its far plane at 16.
const InverseMatrices of_nine_pixels = inverse_matrices(
    view_from({1, 2, 3}),
    {.resolution = three, .vertical_fov = right_angle, .near_plane = 1, .far_plane = 16});

}  // namespace

TEST_CASE("the middle pixel of an odd picture lies in the middle of the screen (MRT §1)",
          "[part pixel_on_screen]") {
    CHECK(on_screen({.row = 1, .column = 1}, three, right_angle, {0, 0}));
    CHECK(on_screen({.row = 2, .column = 3}, {.width = 7, .height = 5}, right_angle, {0, 0}));
}

TEST_CASE("the center of a corner pixel on the screen (MRT §1)", "[3 points]") {
    CHECK(on_screen({.row = 0, .column = 0}, three, right_angle, {-two_thirds, two_thirds}));
    CHECK(on_screen({.row = 2, .column = 2}, three, right_angle, {two_thirds, -two_thirds}));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 1, .height = 1}, right_angle, {0, 0}));
    CHECK(
        on_screen({.row = 0, .column = 0}, vga, right_angle, {Real(-639) / 480, Real(479) / 480}));
}

TEST_CASE(
    "the pixels beside the middle one: y in the first row, x in the last column (MRT §1, i and "
    "j)") {
    CHECK(on_screen({.row = 0, .column = 1}, three, right_angle, {0, two_thirds}));
    CHECK(on_screen({.row = 1, .column = 2}, three, right_angle, {two_thirds, 0}));
}

TEST_CASE("pictures of 4 × 2 and of 2 × 4 pixels: x and y on the screen (MRT §1)") {
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 4, .height = 2}, right_angle,
                    {Real(-1.5), Real(0.5)}));
    CHECK(on_screen({.row = 0, .column = 1}, {.width = 2, .height = 4}, right_angle,
                    {Real(0.25), Real(0.75)}));
}

TEST_CASE("vertical fields of view of 60° and 120° (MRT §1)") {
    const Real tan_30 = 1 / std::sqrt(Real(3));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 2, .height = 2}, pi / 3,
                    Vec2(Real(-0.5), Real(0.5)) * tan_30));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 4, .height = 2}, pi / 3,
                    Vec2(Real(-1.5), Real(0.5)) * tan_30));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 2, .height = 2}, 2 * pi / 3,
                    Vec2(Real(-0.5), Real(0.5)) / tan_30));
}

TEST_CASE("pixels are equal squares around the middle, in any picture (MRT §1)") {
    CHECK(for_all([](Random& random) {
        // Up to 128 times as wide as high: 2 pixNorm - 1 as printed is good to u times that.
        const Resolution size{.width = 64 + random.below(8129), .height = 64 + random.below(8129)};
        const Pixel pixel = random_pixel(size, random);
        const bool wide = random.below(4) == 0;  // almost 180°
        const Real fov =
            wide ? pi - std::ldexp(Real(1), -3 - random.below(7)) : random.between(Real(0.01), 3);
        return on_screen(pixel, size, fov, center_of(pixel, size, fov));
    }));
}

TEST_CASE("the camera's ray starts at 0 and ends on the screen at z = -1 (MRT §1)",
          "[part camera_ray]") {
    const std::string corner =
        "camera_ray({.row = 0, .column = 0}, {.width = 4, .height = 2}, pi / 2)";
    const Ray ray = camera_ray({.row = 0, .column = 0}, {.width = 4, .height = 2}, right_angle);
    CHECK(gives(corner + ".origin", ray.origin, Vec3(0)));
    CHECK(gives(corner + ".direction", ray.direction, Vec3(Real(-1.5), Real(0.5), -1)));
    CHECK(for_all([](Random& random) {
        const Perspective perspective = random_perspective(random);
        const Pixel pixel = random_pixel(perspective.resolution, random);
        const Vec2 screen = center_of(pixel, perspective.resolution, perspective.vertical_fov);
        const std::string asked =
            arguments(pixel, perspective.resolution, perspective.vertical_fov);
        const Ray got = camera_ray(pixel, perspective.resolution, perspective.vertical_fov);
        if (const Verdict origin = gives("the origin of camera_ray" + asked, got.origin, Vec3(0));
            !origin)
            return origin;
        return gives("the direction of camera_ray" + asked, got.direction, Vec3(screen, -1));
    }));
}

TEST_CASE("by inverse matrices the ray starts at the camera and ends on the far plane (M1)",
          "[part unprojected_ray]") {
    const auto& [camera, image] = of_nine_pixels;
    const std::string asked = "unprojected_ray({.row = 0, .column = 2}, camera, image)";
    const Ray ray = unprojected_ray({.row = 0, .column = 2}, camera, image);
    CHECK(gives(asked + ".origin", ray.origin, Vec3(1, 2, 3)));
    CHECK(gives(asked + ".direction", ray.direction, Vec3(Real(32) / 3, Real(32) / 3, -16)));
    const Ray lower = unprojected_ray({.row = 2, .column = 1}, camera, image);
    CHECK(gives("unprojected_ray({.row = 2, .column = 1}, camera, image).direction",
                lower.direction, Vec3(0, Real(-32) / 3, -16)));
}

TEST_CASE("inverse matrices multiplied by a number give the same ray (M1)") {
    // All the same points, in homogeneous coordinates twice and four times as large.
    const auto& [camera, image] = of_nine_pixels;
    const std::string asked = "unprojected_ray({.row = 0, .column = 2}, ";
    const Ray ray = unprojected_ray({.row = 0, .column = 2}, Real(2) * camera, Real(4) * image);
    CHECK(gives(asked + "2 * camera, 4 * image).origin", ray.origin, Vec3(1, 2, 3)));
    CHECK(gives(asked + "2 * camera, 4 * image).direction", ray.direction,
                Vec3(Real(32) / 3, Real(32) / 3, -16)));
    const Ray same = unprojected_ray({.row = 0, .column = 2}, Real(-2) * camera, Real(-4) * image);
    CHECK(gives(asked + "-2 * camera, -4 * image).origin", same.origin, Vec3(1, 2, 3)));
    CHECK(gives(asked + "-2 * camera, -4 * image).direction", same.direction,
                Vec3(Real(32) / 3, Real(32) / 3, -16)));
}

TEST_CASE("both ways give the same ray, to 64 s f^2/n u (MRT §1, M1)") {
    CHECK(for_all([](Random& random) {
        const Perspective perspective = random_perspective(random);
        const Pixel pixel = random_pixel(perspective.resolution, random);
        const auto [camera, image] = inverse_matrices(view_from(Vec3(0)), perspective);
        const Ray mrt = camera_ray(pixel, perspective.resolution, perspective.vertical_fov);
        return same_ray(seen(pixel, perspective), unprojected_ray(pixel, camera, image), mrt,
                        perspective.far_plane, both_ways_bound(perspective, Vec3(0)));
    }));
}

TEST_CASE("the picture of the stage (MRT §1)", "[part together]") {
    CHECK(picture_matches("step01_ray_generation"));
}
