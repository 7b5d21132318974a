// The words in which a choice is told.
#pragma once

#include <string>

namespace rt {

/// Two digits, or all in front of the point.
[[nodiscard]] std::string number(double value);

/// "1 step", "0.5 steps": of an 8-bit picture.
[[nodiscard]] std::string steps(double value);

/// A number that is told whole, and no larger than the value, which is positive.
[[nodiscard]] double two_digits(double value);

/// A line of the report: what was chosen, and why.
[[nodiscard]] std::string line(const std::string& what, const std::string& why);

}  // namespace rt
