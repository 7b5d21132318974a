// Exact numbers, and numbers of a hundred digits.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

#include <compare>

namespace rt::oracle {

/// A hundred decimal digits, and a larger exponent range than any float: for irrational values.
using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                             boost::multiprecision::et_off>;

/// mantissa · 2^exponent, of as many digits as it takes. A float is one of these, and so are sums,
/// differences and products of them: every sign is that of the exact value.
class Exact {
public:
    Exact() = default;
    Exact(double value);  // NOLINT: a float is exactly this
    Exact(int value) : Exact(double(value)) {}

    [[nodiscard]] int sign() const { return mantissa_.sign(); }

    /// The only rounding, to a hundred digits.
    [[nodiscard]] Number number() const;

    Exact operator-() const;
    friend Exact operator+(const Exact& a, const Exact& b);
    friend Exact operator*(const Exact& a, const Exact& b);
    friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
    friend std::strong_ordering operator<=>(const Exact& a, const Exact& b) {
        return (a - b).sign() <=> 0;
    }
    friend bool operator==(const Exact& a, const Exact& b) { return (a - b).sign() == 0; }

private:
    // Half a kilobit without a call for memory, and more if it must be.
    using Whole = boost::multiprecision::number<
        boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                               boost::multiprecision::unchecked,
                                               std::allocator<boost::multiprecision::limb_type>>,
        boost::multiprecision::et_off>;

    Whole mantissa_ = 0;
    int exponent_ = 0;
};

[[nodiscard]] Exact squared(const Exact& x);

}  // namespace rt::oracle
