// What a certified kernel is made of where one word is enough.
#pragma once

#include "common/ray.hpp"

#include <cmath>

namespace rt::inline RT_PRECISION {

/// What is added to a bound of a sum of products: more than what underflows on the way drops.
inline constexpr Real underflow = Real(0x1p-900);

/// Whether products of six such lengths stay numbers, and what underflows beside them is far less
/// than u of them. Kernels take other lengths to more digits, in units of their own.
[[nodiscard]] inline bool moderate(Real least, Real largest) {
    return Real(0x1p-150) < least && largest < Real(0x1p150);
}

// A kernel starts from a point p of the ray that is near the shape, relative to it: fused_at of a
// difference and a t, and what that difference drops. Two sums round, by u |p| each; so does what
// is dropped, by u w: w = u |t| |d| counts where the ray comes from so far that all digits of p are
// among those. So p is within u (2 |p| + w) of the line, wherever on it that t may be.

/// A root that is known but for so much.
struct Estimate {
    Real t;
    Real error;

    /// Whether it is outside the interval, or inside, wherever the root is.
    /// Never if the error is infinite.
    [[nodiscard]] bool before(Interval interval) const { return t < interval.min - error; }
    [[nodiscard]] bool after(Interval interval) const { return t > interval.max + error; }

    [[nodiscard]] bool inside(Interval interval) const {
        return interval.min + error < t && t < interval.max - error;
    }

    /// Whether it is inside, wherever the root is, and no further from it than `most` u t.
    [[nodiscard]] bool answers(Interval interval, Real most) const {
        return error <= most * unit_roundoff * std::abs(t) && inside(interval);
    }
};

}  // namespace rt::inline RT_PRECISION
