#include "docs/accuracy/page.hpp"

#include "docs/figures/svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace rt::accuracy {

std::string power_of_ten(int exponent) {
    constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string words = "10";
    for (const char digit : std::to_string(exponent))
        words += digit == '-' ? "⁻" : digits[digit - '0'];
    return words;
}

std::string power(double value) {
    if (value == 0) return "0";
    char text[16];
    std::snprintf(text, sizeof text, "%.0e", value);
    return std::string{text[0]} + "·" + power_of_ten(std::stoi(std::string(text).substr(2)));
}

std::string two_digits(double value) {
    if (value == 0) return "0";
    char text[16];  // rounded first: 0.996 is 1.0
    std::snprintf(text, sizeof text, "%.1e", value);
    const int before = std::stoi(std::string(text).substr(4)) + 1;
    return figures::decimal(Real(value), std::max(2 - before, 0));
}

std::string thousands(double value) {
    const std::string digits = std::to_string(std::llround(value));
    std::string words;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) words += ',';
        words += digits[i];
    }
    return words;
}

}  // namespace rt::accuracy
