// What a certified kernel is made of where one word is enough.
#pragma once

#include "common/ray.hpp"

#include <cmath>

namespace rt::inline RT_PRECISION {

/// What is added to every bound: more than what underflows on the way drops.
inline constexpr Real underflow = Real(0x1p-900);

/// A root that is known but for so much.
struct Estimate {
    Real t;
    Real error;

    /// Whether it is outside the interval, wherever the root is.
    [[nodiscard]] bool before(Interval interval) const { return t <= interval.min - error; }
    [[nodiscard]] bool after(Interval interval) const { return t >= interval.max + error; }

    /// Whether it is inside, wherever the root is, and no further from it than `most` u t.
    [[nodiscard]] bool answers(Interval interval, Real most) const {
        return error <= most * unit_roundoff * std::abs(t) && interval.min + error < t &&
               t < interval.max - error;
    }
};

}  // namespace rt::inline RT_PRECISION
