// Comparison of the student's explanation of a pixel with the reference's.
#pragma once

#include <string>

namespace rt {

/// Two explanations, line by line: common lines once, different lines beneath one another; equal
/// sections are left out, and the first difference is named. Numbers that differ by rounding alone
/// are equal.
[[nodiscard]] std::string beside(const std::string& mine, const std::string& reference);

}  // namespace rt
