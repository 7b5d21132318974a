// HTML pages that contain untrusted text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt::grade {

/// readable() for HTML and XML, between tags and in quotes.
[[nodiscard]] std::string escaped(std::string_view text);

/// The bytes of a file as a URL: "data:image/png;base64,…".
[[nodiscard]] std::string data_address(std::string_view kind, std::string_view bytes);

/// A page with this body, which is HTML, and this title, which is plain text. It is well-formed XML
/// too.
[[nodiscard]] std::string page(std::string_view title, std::string_view body);

/// "83 %": rounded down, so that only a complete whole is 100 %; empty if `whole` is 0.
[[nodiscard]] std::string percent(int part, int whole);

/// "1 case", "2 cases"
[[nodiscard]] std::string counted(int count, const std::string& what);

// Tables of the HTML pages. Texts are escaped here; rows are HTML.

[[nodiscard]] std::string text_cell(const std::string& text);

/// A fraction as a color ("share") or as a bar ("bar"), and its text, which is HTML.
[[nodiscard]] std::string share_cell(const std::string& kind, int part, int whole,
                                     const std::string& words);

[[nodiscard]] std::string row(const std::string& cells);

[[nodiscard]] std::string table(const std::string& kind, const std::string& rows);

/// The first rows under their headings, with the other rows folded away.
[[nodiscard]] std::string first_rows(const std::string& head, const std::vector<std::string>& rows);

}  // namespace rt::grade
