// The comparison of two explanations as text for the terminal.
#pragma once

#include "common/course/exercise/log_diff.hpp"

namespace rt {

/// The first difference, and its section; then the other sections in which something differs.
/// Common lines are there once, different lines beneath one another. With a command that prints
/// all, it is at most 24 lines of the terminal, and ends with that command if lines are left out.
[[nodiscard]] std::string text(const LogDiff& diff, const std::string& all = "");

}  // namespace rt
