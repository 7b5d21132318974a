// Building, quietly.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// Builds the targets of a build folder, everything if there are none. On a terminal it shows how
/// far it is; what the compiler says is shown only if the build fails. Returns ninja's status.
[[nodiscard]] int build(const std::string& folder, const std::vector<std::string>& targets);

}  // namespace rt
