// Reading of a whole input file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rt {

/// Returns the content of the file, at most `limit` + 1 bytes: the caller detects a file that is
/// too large by the extra byte. Throws InputError for a directory, a device, a pipe, and for a file
/// that is absent or cannot be read.
[[nodiscard]] std::string read_input_file(const std::string& file, std::size_t limit);

/// Returns whether the content begins with the byte order mark of UTF-16 or UTF-32, or without it
/// with letters of ASCII, in which the other bytes are zero. Four zeros are no letter: such a file
/// is binary.
[[nodiscard]] inline bool is_utf16(std::string_view content) {
    const std::string_view start = content.substr(0, 256);
    for (std::size_t i = 0; i + 4 <= start.size(); i += 4)
        if (start.substr(i, 4) == std::string_view("\0\0\0\0", 4)) return false;
    if (content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF")) return true;
    std::string zeros;
    for (const char c : content.substr(0, 4)) zeros += c == '\0' ? '0' : 'x';
    return zeros == "x0x0" || zeros == "0x0x" || zeros == "x000" || zeros == "000x";
}

/// The error of a file that is_utf16.
inline constexpr const char* text_in_utf16 =
    "text in UTF-16 or UTF-32: expected UTF-8, as which an editor can save it";

}  // namespace rt
