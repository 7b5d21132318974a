#include "common/tuning/wording.hpp"

#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <cmath>

namespace rt {

std::string number(double value) {
    return formatted(value >= 99.5 && value < 1e6 ? "%.0f" : "%.2g", value);
}

std::string levels(double value) {
    const std::string text = number(value);
    return text + (text == "1" ? " level" : " levels");
}

double two_digits(double value) {
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    // The tolerance is that of rounding: 3.9999999 is a 4 that was computed.
    constexpr double rounding = 1e-9;
    return std::stod(number(digit * std::floor(value / digit * (1 + rounding))));
}

std::string line(const std::string& what, const std::string& why) {
    constexpr std::size_t width = sizeof "shadow samples" + 1;
    const std::string own = tr(what);
    const std::size_t taken = columns_of(own);
    return "  " + own + std::string(taken < width ? width - taken : 1, ' ') + tr_text(why);
}

}  // namespace rt
