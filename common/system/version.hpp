// The version of the project, and the date.
#pragma once

#include "common/system/files.hpp"

#include <string>

namespace rt {

/// "1.0.0", that of CMakeLists.txt
[[nodiscard]] std::string version_number();

/// The number and a commit, "1.0.0 (52c7ed4)": in a clone the one that is checked out now, and in a
/// hand-out the one from which it was made, whatever repository a student keeps it in. The number
/// alone elsewhere.
[[nodiscard]] std::string version(const fs::path& project);

/// "2026-11-21", today; from SOURCE_DATE_EPOCH (reproducible builds) if two runs must have equal
/// bytes.
[[nodiscard]] std::string today();

}  // namespace rt
