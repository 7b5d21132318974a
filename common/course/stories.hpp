// My story of a pixel beside the reference's.
#pragma once

#include <string>

namespace rt {

/// Two stories, line by line: what both have once, and what differs beneath one another; sections
/// that are alike are left out, and the first difference is named. Numbers that differ by rounding
/// alone count as the same.
[[nodiscard]] std::string beside(const std::string& mine, const std::string& reference);

}  // namespace rt
