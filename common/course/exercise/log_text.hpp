// The comparison of two explanations as text for the terminal.
#pragma once

#include "common/course/exercise/log_diff.hpp"

namespace rt {

/// Common lines once, different lines beneath one another; equal sections are left out, and the
/// first difference is named at the end.
[[nodiscard]] std::string text(const LogDiff& diff);

}  // namespace rt
