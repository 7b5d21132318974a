// Stage 1 against MRT §1 and M1.
#include "steps/step01_ray_generation/ray_generation.hpp"

#include "common/vector.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/picture.hpp"

#include <glm/gtc/matrix_transform.hpp>

using namespace rt;

namespace {

constexpr Real right_angle = pi / 2;  // tan(FOV / 2) = 1
constexpr Resolution vga{.width = 640, .height = 480};

std::string question(Pixel pixel, Resolution resolution, Real fov) {
    return "pixel_on_screen({.row = " + std::to_string(pixel.row) +
           ", .column = " + std::to_string(pixel.column) + "}, {" +
           std::to_string(resolution.width) + ", " + std::to_string(resolution.height) + "}, " +
           text(fov) + ")";
}

Verdict on_screen(Pixel pixel, Resolution resolution, Real fov, Vec2 expected) {
    return gives(question(pixel, resolution, fov), pixel_on_screen(pixel, resolution, fov),
                 expected);
}

/// M1's two matrices for a camera that looks along −z at the origin, moved by `position`, worked
/// out in double whatever Real is. near and far are the distances of the two planes.
struct Inverses {
    Mat4 camera_to_world;
    Mat4 image_to_world;
};

Inverses inverses(Vec3 position, Resolution resolution, Real fov, double near, double far) {
    const double width = resolution.width;
    const double height = resolution.height;
    const glm::dmat4 camera_to_world = glm::translate(glm::dmat4(1), glm::dvec3(position));
    const glm::dmat4 projection = glm::perspective(double(fov), width / height, near, far);
    // −1 to 1 becomes 0 to W from the left, and 0 to H from the top.
    const glm::dmat4 image = glm::translate(glm::dmat4(1), glm::dvec3(width / 2, height / 2, 0)) *
                             glm::scale(glm::dmat4(1), glm::dvec3(width / 2, -height / 2, 1));
    const glm::dmat4 world_to_image = image * projection * glm::inverse(camera_to_world);
    return {Mat4(camera_to_world), Mat4(glm::inverse(world_to_image))};
}

}  // namespace

TEST_CASE("the middle pixel of an odd picture lies in the middle of the screen (MRT §1)") {
    CHECK(on_screen({.row = 1, .column = 1}, {.width = 3, .height = 3}, right_angle, {0, 0}));
    CHECK(on_screen({.row = 2, .column = 3}, {.width = 7, .height = 5}, right_angle, {0, 0}));
}

TEST_CASE("rays go through the centres of pixels: + 0.5, over W and H (MRT §1)") {
    const Resolution three{.width = 3, .height = 3};
    const Real two_thirds = Real(2) / 3;
    CHECK(on_screen({.row = 0, .column = 0}, three, right_angle, {-two_thirds, two_thirds}));
    CHECK(on_screen({.row = 2, .column = 2}, three, right_angle, {two_thirds, -two_thirds}));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 1, .height = 1}, right_angle, {0, 0}));
    CHECK(
        on_screen({.row = 0, .column = 0}, vga, right_angle, {Real(-639) / 480, Real(479) / 480}));
}

TEST_CASE("the row goes down, the column to the right (MRT §1, i and j)") {
    const Resolution three{.width = 3, .height = 3};
    const Real two_thirds = Real(2) / 3;
    CHECK(on_screen({.row = 0, .column = 1}, three, right_angle, {0, two_thirds}));
    CHECK(on_screen({.row = 1, .column = 2}, three, right_angle, {two_thirds, 0}));
}

TEST_CASE("the ratio W / H stretches x (MRT §1)") {
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 4, .height = 2}, right_angle,
                    {Real(-1.5), Real(0.5)}));
    CHECK(on_screen({.row = 0, .column = 1}, {.width = 2, .height = 4}, right_angle,
                    {Real(0.25), Real(0.75)}));
}

TEST_CASE("the field of view is vertical, and halved in the tangent (MRT §1)") {
    const Real tan_30 = 1 / std::sqrt(Real(3));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 2, .height = 2}, pi / 3,
                    Vec2(Real(-0.5), Real(0.5)) * tan_30));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 4, .height = 2}, pi / 3,
                    Vec2(Real(-1.5), Real(0.5)) * tan_30));
    CHECK(on_screen({.row = 0, .column = 0}, {.width = 2, .height = 2}, 2 * pi / 3,
                    Vec2(Real(-0.5), Real(0.5)) / tan_30));
}

TEST_CASE("the whole picture spans the field of view, symmetrically (MRT §1)") {
    CHECK(for_all([](Random& random) {
        const Resolution size{.width = 1 + random.below(2000), .height = 1 + random.below(2000)};
        const Pixel pixel{.row = random.below(size.height), .column = random.below(size.width)};
        const Pixel opposite{.row = size.height - 1 - pixel.row,
                             .column = size.width - 1 - pixel.column};
        const Real fov = random.between(Real(0.1), 3);
        return on_screen(opposite, size, fov, -pixel_on_screen(pixel, size, fov));
    }));
    CHECK(for_all([](Random& random) {
        const Resolution size{.width = 1 + random.below(2000), .height = 1 + random.below(2000)};
        const Real fov = random.between(Real(0.1), 3);
        const Vec2 top = pixel_on_screen({.row = 0, .column = 0}, size, fov);
        // The top row's centre is (H − 1) / H of the way to the edge.
        const Real expected = std::tan(fov / 2) * Real(size.height - 1) / Real(size.height);
        return verdict(close(top.y, expected), question({}, size, fov) + ".y\n  came:     " +
                                                   text(top.y) + "\n  expected: " + text(expected));
    }));
}

TEST_CASE("the camera's ray starts at 0 and ends on the screen at z = -1 (MRT §1)") {
    const Ray ray = camera_ray({.row = 0, .column = 0}, {.width = 4, .height = 2}, right_angle);
    CHECK(gives("its origin", ray.origin, Vec3(0)));
    CHECK(gives("its direction", ray.direction, Vec3(Real(-1.5), Real(0.5), -1)));
}

TEST_CASE("by inverse matrices the ray starts at the camera and ends on the far plane (M1)") {
    const Resolution three{.width = 3, .height = 3};
    const auto [camera, image] = inverses({1, 2, 3}, three, right_angle, 1, 16);
    const Ray ray = unprojected_ray({.row = 0, .column = 2}, camera, image);
    CHECK(gives("its origin", ray.origin, Vec3(1, 2, 3)));
    CHECK(gives("its direction", ray.direction, Vec3(Real(32) / 3, Real(32) / 3, -16)));
}

TEST_CASE("both ends are divided by their w (M1)") {
    // All the same points, in homogeneous coordinates twice and four times as large.
    const Resolution three{.width = 3, .height = 3};
    const auto [camera, image] = inverses({1, 2, 3}, three, right_angle, 1, 16);
    const Ray ray = unprojected_ray({.row = 0, .column = 2}, Real(2) * camera, Real(4) * image);
    CHECK(gives("its origin", ray.origin, Vec3(1, 2, 3)));
    CHECK(gives("its direction", ray.direction, Vec3(Real(32) / 3, Real(32) / 3, -16)));
}

TEST_CASE("both ways give the same ray, to 32 f/n u (MRT §1, M1)") {
    // w on the far plane is 1/f, and comes out of terms as large as 1/n: it is good to a few u
    // times f/n, and so is the direction. f/n is 16 here, as in a small room.
    constexpr double near = 1;
    constexpr double far = 16;
    constexpr Real bound = 32 * Real(far / near) * unit_roundoff;
    CHECK(for_all([](Random& random) {
        const Resolution size{.width = 1 + random.below(640), .height = 1 + random.below(480)};
        const Pixel pixel{.row = random.below(size.height), .column = random.below(size.width)};
        const Real fov = random.between(Real(0.5), 2);
        const auto [camera, image] = inverses(Vec3(0), size, fov, near, far);
        const Ray unprojected = unprojected_ray(pixel, camera, image);
        const Vec3 mrt = unit(camera_ray(pixel, size, fov).direction);
        const Vec3 m1 = unit(unprojected.direction);
        const Vec3 off = abs(m1 - mrt);
        return verdict(std::max({off.x, off.y, off.z}) <= bound, question(pixel, size, fov) +
                                                                     "\n  MRT §1:   " + text(mrt) +
                                                                     "\n  M1:       " + text(m1));
    }));
}

TEST_CASE("the picture of the stage (MRT §1)") {
    CHECK(picture_matches("step01_ray_generation"));
}
