// Sums of products to about the last bit, by keeping what rounding drops.
// Sound only as compiled: -ffp-contract=off, never -ffast-math.
#pragma once

#include "common/real.hpp"

#include <cmath>

namespace rt::inline RT_PRECISION {

/// A rounded result and what the rounding dropped: their exact sum is the exact result.
struct Rounded {
    Real value;
    Real dropped;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// a + b without error (Knuth 1969, TwoSum).
[[nodiscard]] inline Rounded exact_sum(Real a, Real b) {
    const Real sum = a + b;
    const Real b_part = sum - a;
    const Real a_part = sum - b_part;
    return {.value = sum, .dropped = (a - a_part) + (b - b_part)};
}

/// a · b without error, unless it underflows (Ogita, Rump, Oishi 2005, TwoProductFMA).
[[nodiscard]] inline Rounded exact_product(Real a, Real b) {
    const Real product = a * b;
    return {.value = product, .dropped = std::fma(a, b, -product)};
}

/// a · b − c · d within 1.5 ulp, where the plain form can lose every digit (Jeannerod, Louvet,
/// Muller 2013, Kahan's algorithm). Its sign is therefore exact, and exchanging the two products
/// changes it, though not always to the same digits.
[[nodiscard]] inline Real difference_of_products(Real a, Real b, Real c, Real d) {
    const Real cd = c * d;
    const Real difference = std::fma(a, b, -cd);
    const Real dropped = std::fma(-c, d, cd);
    return difference + dropped;
}

/// ⟨a, b⟩ as if computed with twice the digits, then rounded (Ogita, Rump, Oishi 2005, Dot2).
[[nodiscard]] inline Real compensated_dot(Vec3 a, Vec3 b) {
    const Rounded x = exact_product(a.x, b.x);
    const Rounded y = exact_product(a.y, b.y);
    const Rounded z = exact_product(a.z, b.z);
    const Rounded xy = exact_sum(x.value, y.value);
    const Rounded xyz = exact_sum(xy.value, z.value);
    return xyz.value + (xyz.dropped + xy.dropped + x.dropped + y.dropped + z.dropped);
}

/// ⟨n, a − b⟩ with the difference taken exactly, else as compensated_dot.
[[nodiscard]] inline Real compensated_dot(Vec3 n, Vec3 a, Vec3 b) {
    const Rounded x = exact_sum(a.x, -b.x);
    const Rounded y = exact_sum(a.y, -b.y);
    const Rounded z = exact_sum(a.z, -b.z);
    const Vec3 rounded(x.value, y.value, z.value);
    const Vec3 dropped(x.dropped, y.dropped, z.dropped);
    return compensated_dot(n, rounded) + glm::dot(n, dropped);
}

}  // namespace rt
