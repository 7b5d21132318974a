// The wording of the report on automatic settings.
#pragma once

#include <string>

namespace rt {

/// The number with two significant digits, or with all digits before the decimal point if these are
/// no more than six.
[[nodiscard]] std::string number(double value);

/// "1 level", "0.5 levels": an error in levels of an 8-bit picture.
[[nodiscard]] std::string levels(double value);

/// The largest number of two significant digits, which is printed without rounding, not above
/// `value`. The value must be positive.
[[nodiscard]] double two_digits(double value);

/// One line of the report, in the reader's language: the setting chosen, and the reason.
[[nodiscard]] std::string line(const std::string& what, const std::string& why);

}  // namespace rt
