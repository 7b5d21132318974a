// Numbers of as many digits as it takes: what decides where twice the digits leave it open.
// Sound only as compiled: -ffp-contract=off, never -ffast-math.
#pragma once

#include "common/exact/two_words.hpp"

#include <algorithm>
#include <array>

namespace rt::inline RT_PRECISION {

/// A sum of numbers that share no digit, from the smallest to the largest: sums and products of
/// them are exact (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic") as long as
/// nothing underflows, which of numbers about 1 takes a thousand binary digits.
class Expansion {
public:
    Expansion() = default;
    Expansion(Real exactly) { add(exactly); }  // NOLINT: a number is exactly this

    /// -1, 0 or 1; nothing if it is infinite or NaN.
    [[nodiscard]] std::optional<int> sign() const {
        if (count_ == 0) return 0;
        const Real largest = words_[count_ - 1];
        if (!(std::abs(largest) < infinity)) return std::nullopt;
        return largest > 0 ? 1 : -1;
    }

    /// Rounded to two words.
    [[nodiscard]] TwoWords rounded() const {
        TwoWords sum;
        for (std::size_t i = 0; i < count_; ++i) sum = sum + TwoWords(words_[i]);
        return {sum.high, sum.low, 16 * unit_roundoff * unit_roundoff * std::abs(sum.high)};
    }

    friend Expansion operator-(Expansion a) {
        for (std::size_t i = 0; i < a.count_; ++i) a.words_[i] = -a.words_[i];
        return a;
    }

    friend Expansion operator+(Expansion a, const Expansion& b) {
        for (std::size_t i = 0; i < b.count_; ++i) a.add(b.words_[i]);
        a.compress();
        return a;
    }

    friend Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }

    friend Expansion operator*(const Expansion& a, const Expansion& b) {
        if (!a.sign() || !b.sign()) return std::numeric_limits<Real>::quiet_NaN();
        Expansion product;
        for (std::size_t i = 0; i < a.count_; ++i) {
            for (std::size_t k = 0; k < b.count_; ++k) {
                const Rounded both = exact_product(a.words_[i], b.words_[k]);
                product.add(both.dropped);
                product.add(both.value);
            }
            product.compress();
        }
        return product;
    }

private:
    void add(Real number) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const Rounded sum = exact_sum(number, words_[i]);
            number = sum.value;
            if (sum.dropped != 0) words_[kept++] = sum.dropped;
        }
        if (number != 0) words_[kept++] = number;
        count_ = kept;
        if (count_ == most) compress();
    }

    /// The same sum in as few words as hold it.
    void compress() {
        if (count_ < 2) return;
        std::size_t bottom = count_ - 1;
        Real sum = words_[bottom];
        for (std::size_t i = count_ - 1; i-- > 0;) {
            const Rounded both = exact_sum(sum, words_[i]);
            sum = both.value;
            if (both.dropped == 0) continue;
            words_[bottom--] = sum;
            sum = both.dropped;
        }
        words_[bottom] = sum;
        std::size_t top = 0;
        for (std::size_t i = bottom + 1; i < count_; ++i) {
            const Rounded both = exact_sum(words_[i], sum);
            sum = both.value;
            if (both.dropped != 0) words_[top++] = both.dropped;
        }
        words_[top++] = sum;
        count_ = top;
        if (count_ < most) return;
        // Never, of numbers that share no digit: 40 words are all the digits that a number can
        // have.
        std::copy(words_.begin() + 1, words_.end(), words_.begin());
        --count_;
    }

    static constexpr std::size_t most = 128;
    std::array<Real, most> words_;
    std::size_t count_ = 0;
};

}  // namespace rt::inline RT_PRECISION
