// The hints of a stage: steps/stepNN_name/hints.md.
#pragma once

#include <string>

namespace rt {

inline constexpr int hint_levels = 3;

/// The section of one level, such as "## 2"; empty if there is none.
[[nodiscard]] std::string hint_text(int stage, int level);

}  // namespace rt
