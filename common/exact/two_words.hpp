// Double-double numbers with an error bound, on which certified kernels fall back. Valid only as
// compiled here: -ffp-contract=off, never -ffast-math.
#pragma once

#include "common/math/compensated.hpp"

#include <cmath>
#include <optional>

namespace rt {
inline namespace RT_PRECISION {

/// The number high + low, whose distance from the exact result is at most `error`. Each operation
/// bounds its own rounding, and the effect of its operands' errors (Joldes, Muller, Popescu 2017;
/// all their bounds of 3 to 15 u² are taken as 16 u², which includes the rounding of the bound
/// itself).
struct DoubleDouble {
    Real high = 0;
    Real low = 0;
    Real error = 0;

    DoubleDouble() = default;
    DoubleDouble(Real exactly)
        : high(exactly) {}  // NOLINT: implicit, because the conversion is exact
    DoubleDouble(Real high_word, Real low_word, Real at_most)
        : high(high_word), low(low_word), error(at_most) {}

    /// -1, 0 or 1; nothing if the error bound leaves the sign undecided, or if the number is
    /// infinite or NaN.
    [[nodiscard]] std::optional<int> sign() const {
        if (std::abs(high) > Real(1.01) * error && std::abs(high) < infinity)
            return high > 0 ? 1 : -1;
        if (high == 0 && error == 0) return 0;
        return std::nullopt;
    }

    friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low, a.error}; }

    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const Rounded large = exact_sum(a.high, b.high);
        const Rounded small = exact_sum(a.low, b.low);
        const Rounded sum = ordered_sum(large.value, large.dropped + small.value);
        return rounded(ordered_sum(sum.value, sum.dropped + small.dropped), a.error + b.error);
    }

    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const Rounded product = exact_product(a.high, b.high);
        const Real rest = std::fma(a.high, b.low, a.low * b.high);
        const Real doubt = std::abs(a.high) * b.error + (std::abs(b.high) + b.error) * a.error;
        DoubleDouble both = rounded(ordered_sum(product.value, product.dropped + rest), doubt);
        // Below this number, the rounding error of a word may underflow.
        constexpr Real smallest = std::numeric_limits<Real>::min() * Real(0x1p200);
        if (std::abs(both.high) < smallest && a.high != 0 && b.high != 0) both.error += smallest;
        return both;
    }

    friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const Real first = a.high / b.high;
        const DoubleDouble rest = a - b * DoubleDouble(first);
        const Real second = rest.high / b.high;
        const Real doubt =
            (rest.error + std::abs(second) * b.error) / (std::abs(b.high) - 2 * b.error);
        // If the divisor may be 0, there is no bound.
        return rounded(ordered_sum(first, second), doubt >= 0 ? doubt : infinity);
    }

    /// The square root of a number that is not negative.
    [[nodiscard]] friend DoubleDouble square_root(const DoubleDouble& a) {
        if (a.high <= a.error) return {0, 0, 2 * std::sqrt(a.error)};
        const Real first = std::sqrt(a.high);
        const DoubleDouble rest = a - DoubleDouble(first) * DoubleDouble(first);
        return rounded(ordered_sum(first, rest.high / (2 * first)), 2 * rest.error / first);
    }

private:
    /// exact_sum for |a| ≥ |b| or a = 0 (Dekker 1971).
    static Rounded ordered_sum(Real a, Real b) {
        const Real sum = a + b;
        return {.value = sum, .dropped = b - (sum - a)};
    }

    static DoubleDouble rounded(const Rounded& sum, Real doubt) {
        constexpr Real rounding = 16 * unit_roundoff * unit_roundoff;
        return {sum.value, sum.dropped, doubt + rounding * std::abs(sum.value)};
    }
};

}  // namespace RT_PRECISION
}  // namespace rt
