// Text of unknown bytes that people read: in a page, in a table, on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace rt {

/// The text as valid UTF-8, with tab and line feed as its only control characters. Any other byte
/// becomes "�", and so do characters that change the direction of writing, since they can disguise
/// "1 of 9" as another mark.
[[nodiscard]] std::string readable(std::string_view text);

/// The same as one line for a terminal: each control character of ASCII becomes "?".
[[nodiscard]] std::string one_line(std::string text);

}  // namespace rt
