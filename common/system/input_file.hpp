// Reading of a whole input file.
#pragma once

#include <cstddef>
#include <string>

namespace rt {

/// Returns the content of the file, at most `limit` + 1 bytes: the caller detects a file that is
/// too large by the extra byte. Throws InputError for a directory, and for a file that is absent or
/// cannot be read.
[[nodiscard]] std::string read_input_file(const std::string& file, std::size_t limit);

}  // namespace rt
