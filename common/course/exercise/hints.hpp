// The hints of a stage: steps/stepNN_name/hints.md.
#pragma once

#include <string>

namespace rt {

inline constexpr int hint_levels = 3;

/// The section of one level, such as "## 2"; empty if there is none.
[[nodiscard]] std::string hint_text(int stage, int level);

/// The number of levels that there are: a hand-out may have fewer than hint_levels.
[[nodiscard]] int hint_count(int stage);

/// The text of the level about the functions that the part's name contains, if it does; else all of
/// it. A paragraph about a function begins with its name, and a colon or a comma.
[[nodiscard]] std::string hint_text(int stage, int level, const std::string& part);

/// True if the part's name contains the function's, or another label, as whole words.
[[nodiscard]] bool names(const std::string& part, const std::string& label);

}  // namespace rt
