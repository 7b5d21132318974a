// Arbitrary-precision dyadic numbers. They decide the cases that are undecided in twice the working
// precision.
#pragma once

#include "common/exact/two_words.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

/// An integer times a power of two, which represents every Real. Sums, differences and products are
/// exact, without overflow and underflow.
class Dyadic {
public:
    Dyadic() = default;
    Dyadic(Real exactly);  // NOLINT: implicit, because the conversion is exact; infinity and NaN
                           // make an invalid number

    /// -1, 0 or 1; nothing if the number resulted from an infinity or NaN.
    [[nodiscard]] std::optional<int> sign() const {
        if (!number_) return std::nullopt;
        if (digits_.empty()) return 0;
        return negative_ ? -1 : 1;
    }

    /// The number rounded to two words.
    [[nodiscard]] DoubleDouble rounded() const;

    friend Dyadic operator-(Dyadic a) {
        a.negative_ = !a.negative_;
        return a;
    }
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b);

private:
    using Digit =
        std::uint32_t;  // in base 2^32, the least significant first; the outermost digits are not 0
    static constexpr int base = 32;

    [[nodiscard]] int end() const { return lowest_ + int(digits_.size()); }
    [[nodiscard]] std::uint64_t at(int place) const {
        return lowest_ <= place && place < end() ? digits_[std::size_t(place - lowest_)] : 0;
    }
    [[nodiscard]] static bool less(const Dyadic& a, const Dyadic& b);  // compares magnitudes
    void trim();

    std::vector<Digit> digits_;
    int lowest_ = 0;  ///< the place of the first digit: its weight is 2^(32 lowest_)
    bool negative_ = false;
    bool number_ = true;
};

inline Dyadic::Dyadic(Real exactly) : negative_(exactly < 0), number_(std::isfinite(exactly)) {
    if (!number_ || exactly == 0) return;
    // Extracts the most significant digit, then that of the remainder, which is exact as well.
    lowest_ = int(std::floor(Real(std::ilogb(exactly)) / base)) - 2;
    digits_.resize(3);
    Real rest = std::ldexp(std::abs(exactly), -base * lowest_ - 2 * base);
    for (std::size_t i = 3; i-- > 0; rest = std::ldexp(rest, base)) {
        digits_[i] = Digit(rest);
        rest -= Real(digits_[i]);
    }
    trim();
}

inline void Dyadic::trim() {
    while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
    std::size_t zeros = 0;
    while (zeros < digits_.size() && digits_[zeros] == 0) ++zeros;
    digits_.erase(digits_.begin(), digits_.begin() + std::ptrdiff_t(zeros));
    lowest_ += int(zeros);
}

inline bool Dyadic::less(const Dyadic& a, const Dyadic& b) {
    if (a.end() != b.end()) return a.end() < b.end();
    const int lowest = std::min(a.lowest_, b.lowest_);
    for (int place = a.end() - 1; place >= lowest; --place)
        if (a.at(place) != b.at(place)) return a.at(place) < b.at(place);
    return false;
}

inline Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (!a.number_ || (b.number_ && b.digits_.empty())) return a;
    if (!b.number_ || a.digits_.empty()) return b;
    const bool subtracts = a.negative_ != b.negative_;
    if (subtracts && Dyadic::less(a, b)) return b + a;
    Dyadic sum;
    sum.negative_ = a.negative_;
    sum.lowest_ = std::min(a.lowest_, b.lowest_);
    const int end = std::max(a.end(), b.end()) + 1;
    sum.digits_.reserve(std::size_t(end - sum.lowest_));
    std::uint64_t carried = 0;  // the borrow in a difference
    for (int place = sum.lowest_; place < end; ++place) {
        const std::uint64_t digit =
            subtracts ? a.at(place) - b.at(place) - carried : a.at(place) + b.at(place) + carried;
        sum.digits_.push_back(Dyadic::Digit(digit));
        carried = digit >> Dyadic::base & 1;
    }
    sum.trim();
    return sum;
}

inline Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic product;
    product.number_ = a.number_ && b.number_;
    if (a.digits_.empty() || b.digits_.empty()) return product;
    product.negative_ = a.negative_ != b.negative_;
    product.lowest_ = a.lowest_ + b.lowest_;
    product.digits_.resize(a.digits_.size() + b.digits_.size());
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
        std::uint64_t carried = 0;
        for (std::size_t k = 0; k < b.digits_.size(); ++k) {
            Dyadic::Digit& digit = product.digits_[i + k];
            carried += std::uint64_t(a.digits_[i]) * b.digits_[k] + digit;
            digit = Dyadic::Digit(carried);
            carried >>= Dyadic::base;
        }
        product.digits_[i + b.digits_.size()] = Dyadic::Digit(carried);
    }
    product.trim();
    return product;
}

inline DoubleDouble Dyadic::rounded() const {
    if (!number_) return std::numeric_limits<Real>::quiet_NaN();
    DoubleDouble sum;
    const int last = std::max(lowest_, end() - 6);  // lower places are less than u² of the number
    for (int place = last; place < end(); ++place)
        sum = sum + DoubleDouble(std::ldexp(Real(at(place)), base * place));
    // Far from 1, places or words may be outside the range of Real.
    constexpr Real smallest = std::numeric_limits<Real>::min() * Real(0x1p200);
    sum.error += 16 * unit_roundoff * unit_roundoff * sum.high + smallest;
    if (digits_.empty()) sum.error = 0;
    return negative_ ? -sum : sum;
}

}  // namespace RT_PRECISION
}  // namespace rt
