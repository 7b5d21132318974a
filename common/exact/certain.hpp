// Basic bounds of the certified kernels, for computations in working precision.
#pragma once

#include "common/geometry/ray.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// A term for bounds of sums of products: larger than the total error of intermediate underflows.
inline constexpr Real underflow = Real(0x1p-900);

/// Returns whether products of six lengths in this range neither over- nor underflow by more than u
/// of their size. For other lengths, kernels use more digits, in scaled units.
[[nodiscard]] inline bool moderate(Real least, Real largest) {
    return Real(0x1p-150) < least && largest < Real(0x1p150);
}

// A kernel starts from a point p of the ray near the shape, relative to the shape: fused_at of a
// difference and a t, plus the rounding error of that difference. Two sums round, by u |p| each;
// the rounding error is itself rounded by u w, where w = u |t| |d| matters if the ray's origin is
// so far away that all digits of p are in that error. So p is within u (2 |p| + w) of the line, for
// any t.

/// An approximate root with a bound on its error.
struct Estimate {
    Real t;
    Real error;

    /// Returns whether the root is certainly before the interval; `after` and `inside` are
    /// analogous. False for an infinite error.
    [[nodiscard]] bool before(Interval interval) const { return t < interval.min - error; }
    [[nodiscard]] bool after(Interval interval) const { return t > interval.max + error; }

    [[nodiscard]] bool inside(Interval interval) const {
        return interval.min + error < t && t < interval.max - error;
    }

    /// Returns whether the root is certainly inside, and its error is at most `most` u t.
    [[nodiscard]] bool answers(Interval interval, Real most) const {
        return error <= most * unit_roundoff * std::abs(t) && inside(interval);
    }
};

}  // namespace RT_PRECISION
}  // namespace rt
