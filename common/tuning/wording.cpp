#include "common/tuning/wording.hpp"

#include <cmath>
#include <cstdio>

namespace rt {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value >= 99.5 ? "%.0f" : "%.2g", value);
    return text;
}

std::string levels(double value) {
    return number(value) + (value == 1 ? " level" : " levels");
}

double two_digits(double value) {
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    return std::stod(number(digit * std::floor(value / digit)));
}

std::string line(const std::string& what, const std::string& why) {
    constexpr std::size_t width = sizeof "shadow samples" + 1;
    return "  " + what + std::string(width - what.size(), ' ') + why;
}

}  // namespace rt
