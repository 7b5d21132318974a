// A ray and the part of it that is asked about.
#pragma once

#include "common/real.hpp"

namespace rt::inline RT_PRECISION {

/// The half-line origin + t · direction, t > 0.
/// The direction is any non-zero finite vector, and t counts in its length: the worked situations
/// of PHY use directions that are not of unit length.
struct Ray {
    Vec3 origin;
    Vec3 direction;
};

/// The open interval of t in which a hit counts. "Strictly" is what keeps t = 0 from being one.
struct Interval {
    Real min = 0;
    Real max = infinity;

    /// Whether t lies strictly inside; never for NaN or an infinite t.
    [[nodiscard]] constexpr bool contains(Real t) const { return min < t && t < max; }
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The point of the ray at t.
[[nodiscard]] inline Vec3 at(const Ray& ray, Real t) {
    return ray.origin + t * ray.direction;
}

}  // namespace rt
