// What GLM leaves open about vectors.
#pragma once

#include "common/real.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace rt {

/// |x|, |y| or |z|, whichever is largest.
[[nodiscard]] inline Real largest_component(Vec3 v) {
    // Not glm::abs, which is a branch for each.
    return glm::max(std::fabs(v.x), glm::max(std::fabs(v.y), std::fabs(v.z)));
}

/// The largest power of two that is not above a positive number: a unit to compute in, since a
/// division by it rounds nothing. Of a number below the normal ones, the smallest of these.
[[nodiscard]] inline Real power_of_two_below(Real number) {
    // The exponent alone: std::ilogb and std::scalbn are two calls, and more than the division.
    using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
    constexpr Bits exponent = std::bit_cast<Bits>(infinity);
    const Real normal = glm::max(number, std::numeric_limits<Real>::min());
    return std::bit_cast<Real>(std::bit_cast<Bits>(normal) & exponent);
}

/// Whether in a sum of squares, such as this one, what underflowed is far less than u of it, and
/// nothing overflowed.
[[nodiscard]] inline bool keeps_its_digits(Real square) {
    constexpr Real smallest = std::numeric_limits<Real>::min() / (unit_roundoff * unit_roundoff);
    return smallest <= square && square < infinity;
}

/// v made unit length, to 4 u, for any non-zero finite v: where its square might over- or
/// underflow, the largest component is divided out first. Every component of a zero v comes back
/// NaN.
[[nodiscard]] inline Vec3 unit(Vec3 v) {
    const Real square = glm::dot(v, v);
    if (square == 1) return v;  // many are already, and the division would not change it
    if (keeps_its_digits(square)) return v / std::sqrt(square);
    const Vec3 scaled = v / largest_component(v);
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// The normal turned to the side that the direction comes from. Shading wants it; shapes give
/// outward normals.
[[nodiscard]] inline Vec3 facing(Vec3 normal, Vec3 direction) {
    return glm::dot(normal, direction) > 0 ? -normal : normal;
}

}  // namespace rt
