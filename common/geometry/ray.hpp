// A ray, and the interval of it in which hits count.
#pragma once

#include "common/math/real.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// The half-line origin + t · direction, t > 0. The direction is any non-zero finite vector, and t
/// counts in units of its length: the worked situations of PHY use directions that are not of unit
/// length.
struct Ray {
    Vec3 origin;
    Vec3 direction;
};

/// The open interval of t in which a hit counts. Because it is open, t = 0 is not a hit.
struct Interval {
    Real min = 0;
    Real max = infinity;

    /// Returns whether t is strictly inside; false for NaN and for infinite t.
    [[nodiscard]] constexpr bool contains(Real t) const { return min < t && t < max; }
};

}  // namespace RT_PRECISION

/// The point of the ray at t.
[[nodiscard]] inline Vec3 at(const Ray& ray, Real t) {
    return ray.origin + t * ray.direction;
}

}  // namespace rt
