// Numbers of twice the digits that know how wrong they may be: what certified kernels fall back on.
// Sound only as compiled: -ffp-contract=off, never -ffast-math.
#pragma once

#include "common/compensated.hpp"

#include <cmath>
#include <optional>

namespace rt::inline RT_PRECISION {

/// high + low, and no further than `error` from what was asked for. Each operation bounds what it
/// rounds, and what its operands' errors come to (Joldes, Muller, Popescu 2017, whose bounds of 3
/// to 15 u² are all taken as 16 u²: the rest is what computing the bound itself rounds).
struct TwoWords {
    Real high = 0;
    Real low = 0;
    Real error = 0;

    TwoWords() = default;
    TwoWords(Real exactly) : high(exactly) {}  // NOLINT: a number is exactly this
    TwoWords(Real high_word, Real low_word, Real at_most)
        : high(high_word), low(low_word), error(at_most) {}

    /// -1, 0 or 1; nothing if the error leaves it open, or if the number is none.
    [[nodiscard]] std::optional<int> sign() const {
        if (std::abs(high) > Real(1.01) * error && std::abs(high) < infinity)
            return high > 0 ? 1 : -1;
        if (high == 0 && error == 0) return 0;
        return std::nullopt;
    }

    friend TwoWords operator-(const TwoWords& a) { return {-a.high, -a.low, a.error}; }

    friend TwoWords operator+(const TwoWords& a, const TwoWords& b) {
        const Rounded large = exact_sum(a.high, b.high);
        const Rounded small = exact_sum(a.low, b.low);
        const Rounded sum = ordered_sum(large.value, large.dropped + small.value);
        return rounded(ordered_sum(sum.value, sum.dropped + small.dropped), a.error + b.error);
    }

    friend TwoWords operator-(const TwoWords& a, const TwoWords& b) { return a + -b; }

    friend TwoWords operator*(const TwoWords& a, const TwoWords& b) {
        const Rounded product = exact_product(a.high, b.high);
        const Real rest = std::fma(a.high, b.low, a.low * b.high);
        const Real doubt = std::abs(a.high) * b.error + (std::abs(b.high) + b.error) * a.error;
        TwoWords both = rounded(ordered_sum(product.value, product.dropped + rest), doubt);
        // Below that, a word that is dropped is below the smallest numbers.
        constexpr Real smallest = std::numeric_limits<Real>::min() * Real(0x1p200);
        if (std::abs(both.high) < smallest && a.high != 0 && b.high != 0) both.error += smallest;
        return both;
    }

    friend TwoWords operator/(const TwoWords& a, const TwoWords& b) {
        const Real first = a.high / b.high;
        const TwoWords rest = a - b * TwoWords(first);
        const Real second = rest.high / b.high;
        const Real doubt =
            (rest.error + std::abs(second) * b.error) / (std::abs(b.high) - 2 * b.error);
        // A divisor that may be 0 bounds nothing.
        return rounded(ordered_sum(first, second), doubt >= 0 ? doubt : infinity);
    }

    /// Of a positive number.
    [[nodiscard]] friend TwoWords square_root(const TwoWords& a) {
        if (a.high <= a.error) return {0, 0, 2 * std::sqrt(a.error)};
        const Real first = std::sqrt(a.high);
        const TwoWords rest = a - TwoWords(first) * TwoWords(first);
        return rounded(ordered_sum(first, rest.high / (2 * first)), 2 * rest.error / first);
    }

private:
    /// exact_sum where |a| ≥ |b| or a = 0 (Dekker 1971).
    static Rounded ordered_sum(Real a, Real b) {
        const Real sum = a + b;
        return {.value = sum, .dropped = b - (sum - a)};
    }

    static TwoWords rounded(const Rounded& sum, Real doubt) {
        constexpr Real rounding = 16 * unit_roundoff * unit_roundoff;
        return {sum.value, sum.dropped, doubt + rounding * std::abs(sum.value)};
    }
};

}  // namespace rt::inline RT_PRECISION
