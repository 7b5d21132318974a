// std::from_chars for numbers that are not whole, which libc++ has only from version 20 on, and
// macOS therefore not.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace rt {

/// The same by the C library, for decimal numbers. (In the "C" locale, which a program has until it
/// selects another.)
template <std::floating_point Number>
std::from_chars_result parse_floating_in_c(std::string_view text, Number& value) {
    const std::size_t end = text.find_first_not_of("0123456789+-.eE");
    const std::string number(text.substr(0, end));  // it ends in a zero byte, and is no "0x1p3"
    char* rest = nullptr;
    Number parsed = 0;
    if constexpr (std::is_same_v<Number, float>)
        parsed = std::strtof(number.c_str(), &rest);
    else
        parsed = std::strtod(number.c_str(), &rest);
    if (rest == number.c_str() || number.front() == '+')
        return {text.data(), std::errc::invalid_argument};
    const std::string_view digits(number.c_str(), std::size_t(rest - number.c_str()));
    const std::string_view mantissa = digits.substr(0, digits.find_first_of("eE"));
    const bool is_zero = mantissa.find_first_of("123456789") == std::string_view::npos;
    const char* const last = text.data() + digits.size();
    if (std::isinf(parsed) || (parsed == 0 && !is_zero))
        return {last, std::errc::result_out_of_range};
    value = parsed;
    return {last, std::errc()};
}

/// The number at the start of the text, rounded to nearest; the result is that of std::from_chars.
template <std::floating_point Number>
std::from_chars_result parse_floating(std::string_view text, Number& value) {
#ifdef __cpp_lib_to_chars
    return std::from_chars(text.data(), text.data() + text.size(), value);
#else
    return parse_floating_in_c(text, value);
#endif
}

/// The number that the whole text is; nothing if it is none, or out of range.
template <std::floating_point Number>
std::optional<Number> whole_floating(std::string_view text) {
    Number value = 0;
    const auto [end, error] = parse_floating(text, value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

// Options that are a pair of numbers: a size, a pixel, a part of a class.

/// Parses two integers with `separator` between them and nothing around them.
[[nodiscard]] std::optional<std::array<int, 2>> two_numbers(std::string_view text, char separator);

}  // namespace rt
