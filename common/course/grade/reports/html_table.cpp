#include "common/course/grade/reports/html_table.hpp"

#include "common/course/grade/reports/html.hpp"

#include "common/system/translation.hpp"

#include <algorithm>

namespace rt::grade {

namespace {

constexpr std::size_t most_rows = 15;
constexpr std::size_t most_folded = 200;

}  // namespace

std::string text_cell(const std::string& text) {
    return "<td class=\"text\">" + escaped(text) + "</td>";
}

std::string share_cell(const std::string& kind, int part, int whole, const std::string& words) {
    const std::string share = std::to_string(std::min(100, 100 * part / std::max(whole, 1)));
    return "<td class=\"" + kind + "\" style=\"--share: " + share + "%\">" + words + "</td>";
}

std::string row(const std::string& cells) {
    return "<tr>" + cells + "</tr>\n";
}

std::string table(const std::string& kind, const std::string& rows) {
    return "<div class=\"scroll\"><table class=\"" + kind + "\">\n" + rows + "</table></div>\n";
}

std::string first_rows(const std::string& head, const std::vector<std::string>& rows) {
    std::string first = head;
    std::string folded = head;
    const std::size_t shown = std::min(rows.size(), most_rows + most_folded);
    for (std::size_t i = 0; i < shown; ++i) (i < most_rows ? first : folded) += rows[i];
    if (rows.size() <= most_rows) return table("list", first);
    const Values values = {{"number", std::to_string(rows.size() - most_rows)},
                           {"shown", std::to_string(most_folded)}};
    const std::string summary = shown < rows.size()
                                    ? tr("{number} more, of which {shown} are here", values)
                                    : tr("{number} more", values);
    return table("list", first) + "<details><summary>" + summary + "</summary>\n" +
           table("list", folded) + "</details>\n";
}

}  // namespace rt::grade
