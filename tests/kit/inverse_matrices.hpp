// M1's rays as results of inverse matrices: the matrices, and a bound of their rounding.
#pragma once

#include "tests/kit/exact.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/verdict.hpp"

#include "common/image/pixel.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace rt {

/// The parameters of OpenGL's camera, apart from its position: the planes are at distances from it.
struct Perspective {
    Resolution resolution;
    Real vertical_fov;
    Real near_plane;
    Real far_plane;
};

struct InverseMatrices {
    Mat4 camera_to_world;  ///< V⁻¹
    Mat4 image_to_world;   ///< (I P V)⁻¹
};

/// M1's matrices as OpenGL has them, inverted one by one and rounded to Real at the end. Inverting
/// the product would lose hundreds of u where Exact is double.
inline InverseMatrices inverse_matrices(const Mat4& view, const Perspective& perspective) {
    using Matrix = glm::mat<4, 4, Exact>;
    using Vector = glm::vec<3, Exact>;
    const auto& [resolution, fov, near, far] = perspective;
    const Exact width = resolution.width;
    const Exact height = resolution.height;
    // −1 to 1 becomes 0 to W from the left, 0 to H from the top, 0 to 1 from the near plane.
    const Matrix image = glm::translate(Matrix(1), Vector(width / 2, height / 2, Exact(0.5))) *
                         glm::scale(Matrix(1), Vector(width / 2, -height / 2, Exact(0.5)));
    const Matrix projection = glm::perspective(Exact(fov), width / height, Exact(near), Exact(far));
    const Matrix camera_to_world = glm::inverse(Matrix(view));
    return {
        .camera_to_world = Mat4(camera_to_world),
        .image_to_world = Mat4(camera_to_world * glm::inverse(projection) * glm::inverse(image))};
}

/// The bound of the difference, in each coordinate, between M1's ends and MRT's: 64 s (f / n) (f +
/// ‖o_C‖) u, with s the largest coordinate of the screen at distance 1, and at least 1.
///
/// On the far plane w = 1/n + (1/f − 1/n) = 1/f is the difference of numbers as large as 1/n, so
/// its relative error is 3 (f/n) u. It moves the end towards the world's origin or away from it by
/// the same fraction of their distance, at most √3 s f + ‖o_C‖. Before the division the end is a
/// sum of numbers of the size of s and ‖o_C‖ / n, and so are both rays' roundings: less than sixty
/// of them.
inline Real both_ways_bound(const Perspective& perspective, Vec3 position) {
    const auto& [resolution, fov, near, far] = perspective;
    const Real half_height = std::tan(fov / 2);
    const Real half_width = half_height * Real(resolution.width) / Real(resolution.height);
    const Real s = std::max({Real(1), half_width, half_height});
    return 64 * s * (far / near) * (far + length(position)) * unit_roundoff;
}

/// "row 1, column 2 of 640 x 480 pixels, …": the start of a failure's message.
inline std::string seen(Pixel pixel, const Perspective& perspective) {
    const auto& [resolution, fov, near, far] = perspective;
    return "row " + std::to_string(pixel.row) + ", column " + std::to_string(pixel.column) +
           " of " + std::to_string(resolution.width) + " x " + std::to_string(resolution.height) +
           " pixels, vertical_fov " + text(fov) + ", planes at " + text(near) + " and " + text(far);
}

/// M1's ray starts at the same point as MRT's, and its t = 1 is MRT's t = f, within the bound.
inline Verdict same_ray(const std::string& asked, const Ray& m1, const Ray& mrt, Real far_plane,
                        Real bound) {
    const auto agree = [bound](Vec3 a, Vec3 b) {
        const Vec3 off = abs(a - b);
        return off.x <= bound && off.y <= bound && off.z <= bound;
    };
    const Ray as_long{.origin = mrt.origin, .direction = far_plane * mrt.direction};
    return verdict(agree(m1.origin, as_long.origin) && agree(m1.direction, as_long.direction),
                   asked + "\n  M1:       " + code(m1) + "\n  MRT, * f: " + code(as_long) +
                       "\n  within:   " + text(bound));
}

inline Perspective random_perspective(Random& random) {
    const Real near = random.between(Real(0.5), 2);
    return {.resolution = {.width = 1 + random.below(640), .height = 1 + random.below(480)},
            .vertical_fov = random.between(Real(0.5), 2),
            .near_plane = near,
            .far_plane = near * random.between(2, 16)};
}

inline Pixel random_pixel(Resolution resolution, Random& random) {
    const int row = random.below(resolution.height);
    return {.row = row, .column = random.below(resolution.width)};
}

}  // namespace rt
