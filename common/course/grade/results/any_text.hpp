// Text files that lecturers and spreadsheets write, in any of their encodings.
#pragma once

#include <filesystem>
#include <string>

namespace rt::grade {

struct AnyText {
    std::string text;     ///< UTF-8 without a byte order mark; LF for CR in a text without LF
    bool marked = false;  ///< the file has a byte order mark, or is not UTF-8
};

/// Reads UTF-8, UTF-16 with a byte order mark, or else Windows' code page 1252. Throws InputError
/// if the file cannot be read.
[[nodiscard]] AnyText read_any_text(const std::filesystem::path& file);

}  // namespace rt::grade
