// The contracts of stages 1 to 8 other than intersections, and the mirror and the boxes, against
// exact arithmetic: docs/reference/stability.md. Errors are in u of the worst rounding error of
// numbers of the inputs' size.
#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"
#include "steps/step12_mirror/mirror.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/oracle/inputs.hpp"

#include "common/bvh/bvh.hpp"
#include "common/math/vector.hpp"

#include <array>
#include <cmath>

using namespace rt;
using oracle::Number;
using oracle::NumberVector;

namespace {

constexpr int cases = 4'000;

/// The difference of two numbers, in u of a size.
double error(Real got, const Number& exact, double size = 1) {
    return abs(exact - got).convert_to<double>() / (double(unit_roundoff) * size);
}

double error(Vec3 got, const NumberVector& exact, double size = 1) {
    return std::max(
        {error(got.x, exact.x, size), error(got.y, exact.y, size), error(got.z, exact.z, size)});
}

/// Not NaN either.
Verdict within(double error, double bar, const std::string& what) {
    return verdict(error <= bar, what + " is " + std::to_string(error) + " u off, and " +
                                     std::to_string(bar) + " u is promised");
}

/// 10^low to 10^high, of either sign.
Real decades(Random& random, Real low, Real high) {
    return (random.coin() ? 1 : -1) * std::pow(Real(10), random.between(low, high));
}

constexpr Real range = sizeof(Real) == 8 ? 290 : 35;  ///< of a Real's decades

double sum_of_sizes(Vec3 a, Vec3 b) {
    return double(dot(abs(a), abs(b)));
}

Triangle draw_triangle(Random& random) {
    const Vec3 a = random.point(2);
    const Basis basis = random.basis();
    const Real width = std::abs(decades(random, -4, 0));
    const Vec3 b = a + basis.z;
    const Vec3 c = a + random.between(0, 1) * basis.z + width * basis.x;
    const Real scale = std::abs(decades(random, -range / 2, range / 2));
    return {.a = scale * a, .b = scale * b, .c = scale * c};
}

/// The ratio of length to thickness: the condition number of its normal and weights.
double thinness(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const auto u = exact(b) - exact(a);
    const auto v = exact(c) - exact(a);
    const Number squares = (dot(u, u) + dot(v, v)).number();
    return Number(squares / length(cross(u, v))).convert_to<double>();
}

}  // namespace

TEST_CASE("a pixel's place on the screen is within 5 u of itself") {
    CHECK(for_all(
        [](Random& random) {
            const Resolution size{.width = 1 + random.below(8192),
                                  .height = 1 + random.below(8192)};
            const Pixel pixel{.row = random.below(size.height), .column = random.below(size.width)};
            const Real fov = std::abs(decades(random, -6, Real(0.49)));
            const auto [x, y] = oracle::pixel_on_screen(pixel, size, fov);
            const Vec2 got = pixel_on_screen(pixel, size, fov);
            const Ray ray = camera_ray(pixel, size, fov);
            const auto relative = [](Real number, const Number& exact) {
                return exact == 0 ? error(number, exact)
                                  : error(number, exact, abs(exact).convert_to<double>());
            };
            if (ray.origin != Vec3(0) || ray.direction != Vec3(got, -1))
                return verdict(false, "camera_ray is not through pixel_on_screen");
            return within(std::max(relative(got.x, x), relative(got.y, y)), 5,
                          "pixel_on_screen({" + std::to_string(pixel.row) + ", " +
                              std::to_string(pixel.column) + "}, …, " + text(fov) + ")");
        },
        cases));
}

TEST_CASE("a ray from inverse matrices is within 12 u of the terms of its sums") {
    CHECK(for_all(
        [](Random& random) {
            Mat4 camera;
            Mat4 image;
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row) {
                    camera[column][row] = random.between(-2, 2);
                    image[column][row] = random.between(-2, 2);
                }
            const Pixel pixel{.row = random.below(2000), .column = random.below(2000)};
            const auto expected = oracle::unprojected_ray(pixel, exact(camera), exact(image));
            const Ray got = unprojected_ray(pixel, camera, image);
            // Each coordinate's sum of sizes, over w; and w's own relative error.
            const Vec4 point(Real(pixel.column) + Real(0.5), Real(pixel.row) + Real(0.5), 1, 1);
            const auto sizes = [](const Mat4& m, Vec4 p) {
                Mat4 size = m;
                for (int i = 0; i < 4; ++i) size[i] = abs(m[i]);
                const Vec4 sum = size * abs(p);
                const Real w = (m * p).w;
                const Vec3 place = Vec3(m * p) / w;
                return double(largest_component(Vec3(sum) / w) +
                              largest_component(place) * std::abs(sum.w / w));
            };
            const double start = sizes(camera, Vec4(0, 0, 0, 1));
            const double end = sizes(image, point);
            return within(std::max(error(got.origin, expected.origin, start),
                                   error(got.direction, expected.direction, start + end)),
                          12, "unprojected_ray");
        },
        cases));
}

TEST_CASE("bases are within 10 u, up to the vertical and at any length (MRT §2)") {
    CHECK(for_all(
        [](Random& random) {
            const Real length = std::abs(decades(random, -range, range));
            const Real beside = std::abs(decades(random, random.coin() ? -range : -16, 0));
            const Vec3 aside = beside * random.direction();
            Vec3 z = length * Vec3(aside.x, random.coin() ? 1 : -1, aside.z);
            if (random.below(4) == 0) z = length * random.direction();
            if (random.below(16) == 0) z.x = 0;
            if (random.below(16) == 0) z.z = 0;
            const auto off = [](const Basis& got, const oracle::Basis<Number>& expected) {
                return std::max(
                    {error(got.x, expected.x), error(got.y, expected.y), error(got.z, expected.z)});
            };
            return within(std::max(off(orthonormal_basis(z), oracle::orthonormal_basis(exact(z))),
                                   off(camera_basis(z), oracle::camera_basis(exact(z)))),
                          10, "orthonormal_basis(" + code(z) + ")");
        },
        10 * cases));
}

TEST_CASE("a ray carried into the world, and a point into the camera's frame, within 4 u") {
    CHECK(for_all(
        [](Random& random) {
            const Basis basis = random.basis();
            const Vec3 position = random.point(100);
            const Ray ray{.origin = random.point(1), .direction = random.point(1)};
            const Ray got = to_world(ray, basis, position);
            const auto rotated = [&](Vec3 v) { return oracle::rotated(exact(v), exact(basis)); };
            const double size = double(largest_component(ray.direction)) * 3;
            if (const Verdict good =
                    within(std::max(error(got.origin, number(exact(position) + rotated(ray.origin)),
                                          double(largest_component(position)) + 3),
                                    error(got.direction, number(rotated(ray.direction)), size)),
                           4, "to_world");
                !good)
                return good;

            // The last column is rounded; it is the product with the position.
            const Mat4 matrix = view_matrix(basis, position);
            const auto origin = number(oracle::seen({}, exact(basis), exact(position)));
            const bool copied = Vec3(matrix[0]) == Vec3(basis.x.x, basis.y.x, basis.z.x) &&
                                Vec3(matrix[1]) == Vec3(basis.x.y, basis.y.y, basis.z.y) &&
                                Vec3(matrix[2]) == Vec3(basis.x.z, basis.y.z, basis.z.z) &&
                                matrix[0].w == 0 && matrix[1].w == 0 && matrix[2].w == 0 &&
                                matrix[3].w == 1;
            if (!copied) return verdict(false, "view_matrix's axes are not the basis'");
            const double sizes =
                std::max({sum_of_sizes(basis.x, position), sum_of_sizes(basis.y, position),
                          sum_of_sizes(basis.z, position)});
            return within(error(Vec3(matrix[3]), origin, sizes), 4, "view_matrix");
        },
        cases));
}

TEST_CASE("normals of spheres and planes are within 6 u, squares' the basis' own") {
    CHECK(for_all(
        [](Random& random) {
            const Real scale = std::abs(decades(random, -range / 2, range / 2));
            const Vec3 center = scale * random.point(random.coin() ? 2 : 1000);
            const Sphere sphere{.center = center, .radius = scale};
            const Vec3 point = center + scale * random.direction();
            if (const Verdict good = within(
                    error(normal(sphere, point), oracle::normal(exact(sphere), exact(point))), 6,
                    "normal(" + code(sphere) + ", " + code(point) + ")");
                !good)
                return good;
            const Plane plane{.point = center, .normal = scale * random.direction()};
            const Square square{.center = center, .basis = random.basis()};
            if (normal(square, center) != square.basis.z)
                return verdict(false, "a square's normal");
            return within(error(normal(plane, point), oracle::normal(exact(plane), exact(point))),
                          6, "normal(" + code(plane) + ")");
        },
        cases));
}

TEST_CASE("normals of cylinders and cones are within 12 u, and more far along the axis") {
    CHECK(for_all(
        [](Random& random) {
            const auto [across, aside, axis] = random.basis();
            const Real radius = std::abs(decades(random, -3, 3));
            const Real height = std::abs(decades(random, -3, 3));
            const Vec3 foot = random.point(2);
            const Real z = random.between(Real(-0.5), Real(0.5)) * height;
            const Cylinder cylinder{
                .center = foot, .axis = axis, .radius = radius, .height = height};
            const Vec3 on_tube = foot + z * axis + radius * across;
            // Only the component of the distance across the axis counts.
            const double tube = 1 + double(length(on_tube - foot) / radius);
            if (const Verdict good =
                    within(error(normal(cylinder, on_tube),
                                 oracle::normal(exact(cylinder), exact(on_tube)), tube),
                           12, "normal(" + code(cylinder) + ", " + code(on_tube) + ")");
                !good)
                return good;
            const Cone cone{.apex = foot, .axis = axis, .radius = radius, .height = height};
            const Real share = std::abs(decades(random, -6, 0));
            const Vec3 on_cone = foot + share * (height * axis + radius * across);
            const auto out = exact(on_cone) - exact(foot);
            const Number away = length(cross(out, exact(axis)));
            const double side = away > 0 ? 1 + Number(length(out) / away).convert_to<double>() : 1;
            return within(
                error(normal(cone, on_cone), oracle::normal(exact(cone), exact(on_cone)), side), 12,
                "normal(" + code(cone) + ", " + code(on_cone) + ")");
        },
        cases));
}

TEST_CASE("a triangle's normal is the same from any corner, however far one of them is") {
    const Real half = std::sqrt(Real(0.5));
    for (const Real far : {Real(1e4), Real(1e8), Real(1e12), Real(1e17)}) {
        // From (0, 1, 0) and (1, 0, 0) to a corner far above: the normal is across both.
        const Vec3 b(0, 1, 0);
        const Vec3 c(1, 0, 0);
        const Vec3 a(0, 0, far);
        const Vec3 expected =
            Vec3(-half, -half, -half / far) / std::sqrt(1 + half * half / far / far);
        for (const Triangle& triangle :
             {Triangle{.a = a, .b = b, .c = c}, Triangle{.a = b, .b = c, .c = a},
              Triangle{.a = c, .b = a, .c = b}})
            CHECK(gives("normal(" + code(triangle) + ")", normal(triangle, b), expected));
    }
}

TEST_CASE("a triangle's normal is within 16 u of how thin it is, its weights 32 u, at any size") {
    CHECK(for_all(
        [](Random& random) {
            const Triangle triangle = draw_triangle(random);
            const auto& [a, b, c] = triangle;
            const double thin = thinness(triangle);
            if (const Verdict good = within(
                    error(normal(triangle, a), oracle::normal(exact(triangle), exact(a)), thin), 16,
                    "normal(" + code(triangle) + ")");
                !good)
                return good;
            const Real beta = random.between(Real(-0.5), 1);
            const Real gamma = random.between(Real(-0.5), 1);
            const Vec3 point = a + beta * (b - a) + gamma * (c - a);
            return within(error(barycentric(triangle, point),
                                oracle::barycentric(exact(triangle), exact(point)), thin),
                          32, "barycentric(" + code(triangle) + ", " + code(point) + ")");
        },
        cases));
}

TEST_CASE("u and v of a square, colors, the torch and mirrors are within 10 u") {
    CHECK(for_all(
        [](Random& random) {
            const Square square{.center = random.point(2),
                                .basis = random.basis(),
                                .side = std::abs(decades(random, -3, 3))};
            const Vec3 point =
                square.center + square.side * (random.between(-1, 1) * square.basis.x +
                                               random.between(-1, 1) * square.basis.y);
            const Vec2 uv = square_uv(square, point);
            const auto [u, v] = oracle::square_uv(exact(square), exact(point));
            const Vec3 direction =
                std::abs(decades(random, -range / 2, range / 2)) * random.direction();
            const Vec3 n = random.direction();
            // From so near that the difference is exact, or from as far.
            const Vec3 eye = point + decades(random, -3, 3) * random.direction();
            const ShadingPoint surface{.point = {},
                                       .normal = face_forward(n, direction),
                                       .geometric_normal = face_forward(n, direction)};
            const auto size = double(length(direction));
            return within(
                std::max({error(uv.x, u, 2), error(uv.y, v, 2),
                          error(color_from_normal(direction),
                                oracle::color_from_normal(exact(direction))),
                          error(torch(point, direction, eye),
                                oracle::torch(exact(point), exact(direction), exact(eye))),
                          error(mirrored({.direction = direction}, surface).direction,
                                oracle::mirrored(exact(direction), exact(surface.normal)), size)}),
                10, "for " + code(direction) + ", " + code(point) + ", " + code(square));
        },
        cases));
}

TEST_CASE("no box that a ray hits is lost, at its corners and edges either") {
    CHECK(for_all(
        [](Random& random) {
            std::array<BoundingBox, 8> boxes;
            const Real scale = std::abs(decades(random, -12, 12));
            for (BoundingBox& box : boxes) {
                const Vec3 corner = scale * random.point(4);
                box = merged(BoundingBox{.min = corner, .max = corner},
                             corner + scale * random.point(1));
            }
            const BoundingBox& aim = boxes[std::size_t(random.below(8))];
            Vec3 target;
            for (glm::length_t axis = 0; axis < 3;
                 ++axis)  // a corner, or a point of an edge or face
                target[axis] = random.below(3) == 0
                                   ? glm::mix(aim.min[axis], aim.max[axis], random.between(0, 1))
                               : random.coin() ? aim.min[axis]
                                               : aim.max[axis];
            Vec3 direction = random.direction();
            if (random.below(3) == 0) direction[random.below(3)] = 0;
            const Ray ray{.origin = target - scale * random.between(0, 8) * direction,
                          .direction = std::abs(decades(random, -9, 9)) * direction};
            const Bvh hierarchy(boxes.size(), [&](std::size_t i) { return boxes[i]; });
            std::array<bool, 8> seen{};
            Interval interval;
            RayBoxTestCache slabs(ray);
            hierarchy.nearest(slabs, interval, [&](std::uint32_t index) { seen[index] = true; });
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const auto& [min, max] = boxes[i];
                if (!seen[i] &&
                    oracle::overlap(exact(ray), exact(min), exact(max), exact(interval)))
                    return verdict(false, code(ray) + " misses " + code(boxes[i]));
            }
            return Verdict{};
        },
        20 * cases));
}
