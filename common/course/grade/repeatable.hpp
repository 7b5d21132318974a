// The words of tools, as they are in every run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

/// The words without what differs from run to run: the names of these folders and of temporary
/// folders, the compiler's own temporary files, addresses, and the order in which a linker of many
/// threads finds its errors.
[[nodiscard]] std::string repeatable(std::string words,
                                     const std::vector<std::filesystem::path>& folders);

}  // namespace rt::grade
