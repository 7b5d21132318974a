// Sums of products that are accurate to about the last bit, because the rounding error of each
// operation is kept. Valid only as compiled here: -ffp-contract=off, never -ffast-math.
#pragma once

#include "common/math/vector.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace rt {
inline namespace RT_PRECISION {

/// A rounded result and its rounding error: their exact sum is the exact result.
struct Rounded {
    Real value;
    Real dropped;
};

}  // namespace RT_PRECISION

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

/// origin + t · direction with one rounding for each coordinate.
[[nodiscard]] inline Vec3 fused_at(Vec3 origin, Real t, Vec3 direction) {
    return {std::fma(t, direction.x, origin.x), std::fma(t, direction.y, origin.y),
            std::fma(t, direction.z, origin.z)};
}

/// a · b − c · d within 1.5 ulp, where the plain formula can lose every digit (Jeannerod, Louvet,
/// Muller 2013, Kahan's algorithm). The sign is therefore exact. Exchanging the two products
/// changes the sign, though the digits may differ.
[[nodiscard]] inline Real difference_of_products(Real a, Real b, Real c, Real d) {
    const Real cd = c * d;
    const Real difference = std::fma(a, b, -cd);
    const Real dropped = std::fma(-c, d, cd);
    return difference + dropped;
}

/// a × b, every component to 1.5 ulp however small the angle between them.
[[nodiscard]] inline Vec3 compensated_cross(Vec3 a, Vec3 b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

/// The sum of the terms within 1.2 u of itself, however many digits cancel. Each pass keeps the
/// exact sum and leaves it in the last term, except for what the others hold; when that is little,
/// they are added (Ogita, Rump, Oishi 2005, SumK, with as many passes as it takes).
template <std::size_t count>
[[nodiscard]] Real compensated_sum(std::array<Real, count> terms) {
    Real others = 0;
    for (std::size_t pass = 0; pass < 2 * count; ++pass) {
        Real size = 0;
        for (std::size_t i = 1; i < count; ++i) {
            const Rounded sum = exact_sum(terms[i - 1], terms[i]);
            terms[i - 1] = sum.dropped;
            terms[i] = sum.value;
            size += std::abs(sum.dropped);
        }
        if (!(64 * size > std::abs(terms[count - 1]))) break;  // NaN too
    }
    for (std::size_t i = 0; i + 1 < count; ++i) others += terms[i];
    return terms[count - 1] + others;
}

/// Returns whether a sum, computed in twice the precision from terms whose absolute values add up
/// to `size`, has kept enough digits to be accurate to the last one: its error before the last
/// rounding is at most 19 u² of the size, and here therefore 0.3 u of the sum.
[[nodiscard]] inline bool is_accurate(Real sum, Real size) {
    return std::abs(sum) >= 64 * unit_roundoff * size;
}

/// The sum of three exact products, and the sum of all that its roundings dropped (Ogita, Rump,
/// Oishi 2005, Dot2).
[[nodiscard]] inline Rounded sum_with_dropped(const std::array<Rounded, 3>& products) {
    const auto& [x, y, z] = products;
    const Rounded xy = exact_sum(x.value, y.value);
    const Rounded xyz = exact_sum(xy.value, z.value);
    return {.value = xyz.value,
            .dropped = xyz.dropped + xy.dropped + x.dropped + y.dropped + z.dropped};
}

/// ⟨a, b⟩ within 1.2 u of itself, unless a product underflows: computed in twice the working
/// precision, and in as much as it takes where the products cancel most of that.
[[nodiscard]] inline Real compensated_dot(Vec3 a, Vec3 b) {
    const std::array products = {exact_product(a.x, b.x), exact_product(a.y, b.y),
                                 exact_product(a.z, b.z)};
    const auto [value, dropped] = sum_with_dropped(products);
    const Real sum = value + dropped;
    const auto& [x, y, z] = products;
    if (is_accurate(sum, std::abs(x.value) + std::abs(y.value) + std::abs(z.value))) [[likely]]
        return sum;
    return compensated_sum(std::array{x.dropped, y.dropped, z.dropped, x.value, y.value, z.value});
}

/// ⟨v, axis⟩ for a unit vector, with the sign of the exact value and an error of at most 0.006 of
/// it: for a v almost at right angles to the axis, the plain sum would be little more than a
/// rounding error.
[[nodiscard]] inline Real dot_along(Vec3 v, Vec3 axis) {
    const Real plain = glm::dot(v, axis);
    if (std::abs(plain) >= 1024 * unit_roundoff * largest_component(v)) [[likely]]
        return plain;
    return compensated_dot(v, axis);
}

/// ⟨n, a − b⟩ with the difference taken exactly, otherwise like the compensated_dot of two vectors,
/// and within 1.3 u of itself.
[[nodiscard]] inline Real compensated_dot(Vec3 n, Vec3 a, Vec3 b) {
    const std::array differences = {exact_sum(a.x, -b.x), exact_sum(a.y, -b.y),
                                    exact_sum(a.z, -b.z)};
    const auto& [dx, dy, dz] = differences;
    const std::array products = {exact_product(n.x, dx.value), exact_product(n.y, dy.value),
                                 exact_product(n.z, dz.value)};
    const auto [value, dropped] = sum_with_dropped(products);
    const Real sum = value + (dropped + glm::dot(n, Vec3(dx.dropped, dy.dropped, dz.dropped)));
    const auto& [x, y, z] = products;
    if (is_accurate(sum, std::abs(x.value) + std::abs(y.value) + std::abs(z.value))) [[likely]]
        return sum;
    const Rounded small_x = exact_product(n.x, dx.dropped);
    const Rounded small_y = exact_product(n.y, dy.dropped);
    const Rounded small_z = exact_product(n.z, dz.dropped);
    return compensated_sum(std::array{small_x.dropped, small_y.dropped, small_z.dropped,
                                      small_x.value, small_y.value, small_z.value, x.dropped,
                                      y.dropped, z.dropped, x.value, y.value, z.value});
}

}  // namespace rt
