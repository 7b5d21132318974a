// Text of unknown content, made safe for a message, for a URL and for a shell.
#pragma once

#include <string>
#include <string_view>

namespace rt {

/// The text in double quotes for a message. Long text is cut, and every byte that is not printable
/// ASCII is written as \xNN, so that a file cannot send control sequences to the terminal.
[[nodiscard]] std::string quoted(std::string_view text);

/// The text as a part of a URL or of a header (RFC 3986 §2.1): each byte is written as %NN, except
/// for letters and digits of ASCII, and - . _ ~.
[[nodiscard]] std::string percent_encoded(std::string_view text);

/// The word as a shell takes it, in single quotes if it needs any.
[[nodiscard]] std::string shell_word(const std::string& word);

// Text of unknown bytes that people read: in a page, in a table, on a terminal.

/// The text as valid UTF-8, with tab and line feed as its only control characters. Any other byte
/// becomes "�", and so do characters that change the direction of writing, since they can disguise
/// "1 of 9" as another mark.
[[nodiscard]] std::string readable(std::string_view text);

/// The same as one line for a terminal: each control character of ASCII becomes "?".
[[nodiscard]] std::string one_line(std::string text);

}  // namespace rt
