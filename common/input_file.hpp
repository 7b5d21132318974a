// A file from outside, read whole.
#pragma once

#include <cstddef>
#include <string>

namespace rt {

/// The content of the file, at most `limit` bytes and one more, by which the caller sees that it
/// is too large. Throws InputError for a directory, and for what is absent or cannot be read.
[[nodiscard]] std::string read_input_file(const std::string& file, std::size_t limit);

}  // namespace rt
