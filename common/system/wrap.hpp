// Long lines on narrow terminals.
#pragma once

#include <cstddef>
#include <string>

namespace rt {

/// The number of characters of a text in UTF-8.
[[nodiscard]] std::size_t columns_of(const std::string& text);

/// The line, or what fits of it before "…".
[[nodiscard]] std::string shortened(const std::string& line, int columns);

/// The line, broken at spaces outside of quoted texts, so that a line of C++ can be pasted still;
/// not among the numbers of a vector nor beside "=". Continued lines are indented by four more. A
/// part without such a space stays longer.
[[nodiscard]] std::string wrapped(const std::string& line, int columns);

/// The same, with continued lines indented by that many characters.
[[nodiscard]] std::string wrapped(const std::string& line, int columns, std::size_t indent);

/// The same for the width of the terminal; the line itself if the standard output is none.
[[nodiscard]] std::string wrapped(const std::string& line);

/// The same, with continued lines at the left.
[[nodiscard]] std::string wrapped_prose(const std::string& line);

/// A line of C++ for a file of the student's, broken for the width of the terminal, at most 120.
[[nodiscard]] std::string wrapped_code(const std::string& line);

/// A compiler's message: its text is broken, and the lines of code and marks that it quotes, which
/// begin with a blank, end with "…" instead.
[[nodiscard]] std::string wrapped_diagnostic(const std::string& text, int columns);

/// The same for the width of the terminal; the text itself if the standard output is none.
[[nodiscard]] std::string wrapped_diagnostic(const std::string& text);

/// A page of help with each line broken for the width of the terminal, 80 if it is none. The lines
/// that begin with a blank describe options, and go on in that column.
[[nodiscard]] std::string wrapped_page(const std::string& text, std::size_t column);

}  // namespace rt
