#include "tests/oracle/exact.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace rt::oracle {

Exact::Exact(double value) {
    assert(std::isfinite(value));
    constexpr int digits = 53;
    const auto mantissa = std::int64_t(std::ldexp(std::frexp(value, &exponent_), digits));
    if (mantissa == 0) return;
    const int zeros = std::countr_zero(std::uint64_t(mantissa));
    mantissa_ = mantissa >> zeros;
    exponent_ += zeros - digits;
}

Number Exact::number() const {
    if (sign() == 0) return 0;
    const Whole size = abs(mantissa_);
    const int bits = int(msb(size));
    const int dropped = std::max(0, bits - 400);  // far below the last of a hundred digits
    const Number number = ldexp(Number(Whole(size >> dropped)), exponent_ + dropped);
    return sign() < 0 ? Number(-number) : number;
}

Exact Exact::operator-() const {
    Exact negative = *this;
    negative.mantissa_ = -negative.mantissa_;
    return negative;
}

Exact operator+(const Exact& a, const Exact& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    Exact sum;
    sum.mantissa_ = (a.mantissa_ << (a.exponent_ - b.exponent_)) + b.mantissa_;
    sum.exponent_ = b.exponent_;
    return sum;
}

Exact operator*(const Exact& a, const Exact& b) {
    Exact product;
    product.mantissa_ = a.mantissa_ * b.mantissa_;
    product.exponent_ = a.exponent_ + b.exponent_;
    return product;
}

Exact squared(const Exact& x) {
    return x * x;
}

}  // namespace rt::oracle
