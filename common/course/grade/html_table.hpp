// Tables of our pages. Texts are escaped here; rows are HTML.
#pragma once

#include <string>
#include <vector>

namespace rt::grade {

[[nodiscard]] std::string text_cell(const std::string& text);

/// The part of a whole as a colour ("share") or as a bar ("bar"), and in words, which are HTML.
[[nodiscard]] std::string share_cell(const std::string& kind, int part, int whole,
                                     const std::string& words);

[[nodiscard]] std::string row(const std::string& cells);

[[nodiscard]] std::string table(const std::string& kind, const std::string& rows);

/// Where to look first: some rows under their head, and others folded away.
[[nodiscard]] std::string first_rows(const std::string& head, const std::vector<std::string>& rows);

}  // namespace rt::grade
