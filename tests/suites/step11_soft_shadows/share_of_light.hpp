// The share of a light beside a plane, in double.
#pragma once

#include "tests/kit/for_all.hpp"

#include "common/scene/scene.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

using Exact = glm::dvec3;  // expected values are worked out in double, in both precisions
inline constexpr double exact_pi = 3.14159265358979323846;

/// The share of a cone on one side of a plane through its apex. `offset` is the angle from the
/// plane to the axis, positive if the axis is on that side. Over rings of equal solid angle, the
/// share of each that is on that side; the substitution v² takes the corner of the integrand, where
/// the first ring is cut, out. 4000 midpoints: right to 1e-6, as its test shows.
inline double share_beside_plane(double offset, double half_angle) {
    if (std::abs(offset) >= half_angle) return offset > 0 ? 1 : 0;
    const double largest = 1 - std::cos(half_angle);
    const double first = (1 - std::cos(offset)) / largest;  // the first ring that is cut
    double sum = 0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double v = (i + 0.5) / steps;
        const double ring = first + (1 - first) * v * v;
        const double cosine = 1 - ring * largest;
        const double tangent = std::sqrt(1 - cosine * cosine) / cosine;
        sum += std::acos(std::clamp(-std::tan(offset) / tangent, -1.0, 1.0)) / exact_pi * 2 * v;
    }
    return (offset > 0 ? first : 0) + (1 - first) * sum / steps;
}

/// The share of the light on the side of a plane through the point that its unit normal points to.
inline double share_beside_plane(const Light& light, Vec3 from, Exact normal) {
    const Exact way = Exact(light.position) - Exact(from);
    const double distance = length(way);
    return share_beside_plane(std::asin(std::clamp(dot(normal, way) / distance, -1.0, 1.0)),
                              std::asin(light.radius / distance));
}

inline std::uint32_t draw_seed(Random& random) {
    return std::uint32_t(random.choice() * 4294967295.0);
}

/// 64 means of 256 well-spread points: the edge of a shadow crosses fewer than 48 of 256 boxes,
/// each wrong by at most 1 / 256 with even odds, so that the standard error is at most √48 / 2 /
/// 256 / 8. Six of them.
inline constexpr double share_bound = 6 * 0.0017;

}  // namespace rt
