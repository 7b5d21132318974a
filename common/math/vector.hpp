// Vector functions that complement GLM.
#pragma once

#include "common/math/real.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace rt {

/// The largest of |x|, |y| and |z|.
[[nodiscard]] inline Real largest_component(Vec3 v) {
    // Not glm::abs, which compiles to a branch for each component.
    return glm::max(std::fabs(v.x), glm::max(std::fabs(v.y), std::fabs(v.z)));
}

/// The largest power of two that is not above a positive number: a unit of length whose divisions
/// are exact. Below the normal numbers, returns the smallest normal number.
[[nodiscard]] inline Real power_of_two_below(Real number) {
    // Masks the exponent: std::ilogb and std::scalbn are two calls that take longer than the
    // division.
    using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
    constexpr Bits exponent = std::bit_cast<Bits>(infinity);
    const Real normal = glm::max(number, std::numeric_limits<Real>::min());
    return std::bit_cast<Real>(std::bit_cast<Bits>(normal) & exponent);
}

/// Returns whether this sum of squares is accurate: no term overflowed, and what underflowed is far
/// less than u times the sum.
[[nodiscard]] inline bool is_safe_square(Real square) {
    constexpr Real smallest = std::numeric_limits<Real>::min() / (unit_roundoff * unit_roundoff);
    return smallest <= square && square < infinity;
}

/// v scaled to unit length, with an error of at most 4 u, for any non-zero finite v. Where its
/// square might over- or underflow, it is first divided by its largest component. For a zero v,
/// every component of the result is NaN.
[[nodiscard]] inline Vec3 unit(Vec3 v) {
    const Real square = glm::dot(v, v);
    if (square == 1) return v;  // frequent, and the division would not change v
    if (is_safe_square(square)) return v / std::sqrt(square);
    const Vec3 scaled = v / largest_component(v);
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// The normal, flipped if needed to face the side from which `direction` arrives. Shading requires
/// this; the shapes' own normals point outward.
[[nodiscard]] inline Vec3 face_forward(Vec3 normal, Vec3 direction) {
    return glm::dot(normal, direction) > 0 ? -normal : normal;
}

}  // namespace rt
