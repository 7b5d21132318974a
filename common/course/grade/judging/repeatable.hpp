// The output of tools, made identical in every run.
#pragma once

#include "common/system/files.hpp"

#include <string>
#include <vector>

namespace rt::grade {

/// The output without the parts that differ from run to run: the names of `folders` and of
/// temporary folders, the compiler's own temporary files, addresses, and the order of errors from a
/// multi-threaded linker.
[[nodiscard]] std::string repeatable(std::string words, const std::vector<fs::path>& folders);

}  // namespace rt::grade
