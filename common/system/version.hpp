// The version of the project.
#pragma once

#include <filesystem>
#include <string>

namespace rt {

/// "1.0.0", that of CMakeLists.txt, or "1.0.0 (52c7ed4)" if the project's folder is a clone: the
/// commit that is checked out now.
[[nodiscard]] std::string version(const std::filesystem::path& project);

}  // namespace rt
