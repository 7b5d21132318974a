// Tables of the HTML pages. Texts are escaped here; rows are HTML.
#pragma once

#include <string>
#include <vector>

namespace rt::grade {

[[nodiscard]] std::string text_cell(const std::string& text);

/// A fraction as a color ("share") or as a bar ("bar"), and its text, which is HTML.
[[nodiscard]] std::string share_cell(const std::string& kind, int part, int whole,
                                     const std::string& words);

[[nodiscard]] std::string row(const std::string& cells);

[[nodiscard]] std::string table(const std::string& kind, const std::string& rows);

/// The first rows under their headings, with the other rows folded away.
[[nodiscard]] std::string first_rows(const std::string& head, const std::vector<std::string>& rows);

}  // namespace rt::grade
