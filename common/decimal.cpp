#include "common/decimal.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <type_traits>
#include <version>

namespace rt::inline RT_PRECISION {

namespace {

/// Far outside the range of Real, and no overflow when the length of a text is added.
constexpr std::int64_t largest_exponent = 1'000'000'000;

std::string_view take_digits(std::string_view& text) {
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

/// Parses the exponent after 'e', clamped to largest_exponent; nothing if it has no digit.
std::optional<std::int64_t> take_exponent(std::string_view& text) {
    const bool negative = take(text, '-');
    if (!negative) take(text, '+');
    const std::string_view digits = take_digits(text);
    if (digits.empty()) return std::nullopt;
    std::int64_t exponent = 0;
    for (const char digit : digits) {
        exponent = std::min(10 * exponent + (digit - '0'), largest_exponent);
    }
    return negative ? -exponent : exponent;
}

void strip_zeros(Decimal& number) {
    const std::size_t first = number.digits.find_first_not_of('0');
    if (first == std::string::npos) {
        number.digits.clear();
        return;
    }
    number.digits.erase(number.digits.find_last_not_of('0') + 1);
    number.digits.erase(0, first);
    number.point -= static_cast<std::int64_t>(first);
}

/// The Real nearest to an unsigned text of valid form. A value too close to zero becomes 0 or a
/// subnormal number.
Real nearest_real(std::string_view text, const Decimal& number) {
#ifdef __cpp_lib_to_chars
    Real value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc::result_out_of_range) return value;
    return number.point > 0 ? infinity : 0;
#else
    // libc++ before version 20, used on macOS, has no from_chars for floating-point numbers. strtod
    // is equivalent in the "C" locale, which a program uses unless it selects another.
    static_cast<void>(number);
    const std::string copy(text);
    if constexpr (std::is_same_v<Real, float>) return std::strtof(copy.c_str(), nullptr);
    return static_cast<Real>(std::strtod(copy.c_str(), nullptr));
#endif
}

}  // namespace

std::optional<Decimal> parse_decimal(std::string_view text) {
    Decimal number;
    number.negative = take(text, '-');
    if (!number.negative) take(text, '+');
    const std::string_view magnitude = text;

    const std::string_view before = take_digits(text);
    const bool has_point = take(text, '.');
    const std::string_view after = has_point ? take_digits(text) : std::string_view();
    if (before.empty() && after.empty()) return std::nullopt;
    number.scientific = take(text, 'e') || take(text, 'E');
    const auto exponent = number.scientific ? take_exponent(text) : 0;
    if (!exponent || !text.empty()) return std::nullopt;

    number.whole = !has_point && !number.scientific;
    number.digits.append(before).append(after);
    number.point = static_cast<std::int64_t>(before.size()) + *exponent;
    strip_zeros(number);
    number.value = nearest_real(magnitude, number);
    if (number.negative) number.value = -number.value;
    return number;
}

}  // namespace rt::inline RT_PRECISION

namespace rt {

bool exceeds(const Decimal& number, int bound) {
    if (number.digits.empty() || bound == 0) return !number.digits.empty();
    std::string limit = std::to_string(bound);
    const auto length = static_cast<std::int64_t>(limit.size());
    if (number.point != length) return number.point > length;
    // Both have the same number of digits before the point, so the lexicographic order of the
    // digits is the numeric order, once trailing zeros of the bound are removed, as they are in the
    // number.
    limit.erase(limit.find_last_not_of('0') + 1);
    return number.digits > limit;
}

}  // namespace rt
