// Reading of files.
#pragma once

#include <string>

namespace rt::contract {

/// Throws std::runtime_error, if it cannot be read.
[[nodiscard]] std::string content_of(const std::string& file);

}  // namespace rt::contract
