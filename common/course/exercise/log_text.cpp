#include "common/course/exercise/log_text.hpp"

#include "common/course/exercise/failure_text.hpp"
#include "common/system/files.hpp"
#include "common/system/paint.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <limits>

namespace rt {

namespace {

std::string line(const std::string& whose, const std::string& words) {
    constexpr std::size_t columns = 10;
    const std::string label =
        whose + std::string(columns - std::min(columns_of(whose), columns), ' ');
    return (whose.empty() ? label : styled(label, Style::bold)) + words + "\n";
}

/// With fewer digits, and the names of quantities in the reader's language.
std::string shortened(const std::string& text) {
    constexpr int digits = 7;
    return tr_line(with_digits(text, digits));
}

std::string lines(const LogRow& row) {
    const std::string mine = row.mine ? shortened(*row.mine) : "";
    if (!row.differs && !row.may_differ) return line("", mine);
    return (row.mine ? line(tr("mine"), mine) : "") +
           (row.reference ? line(tr("reference"), shortened(*row.reference)) : "");
}

struct Section {
    std::string text;
    bool differs = false;
    bool is_first = false;     ///< has the first difference
    bool is_of_shape = false;  ///< of a test of a shape
};

std::vector<Section> sections_of(const LogDiff& diff) {
    std::vector<Section> sections;
    for (std::size_t i = 0; i < diff.rows.size(); ++i) {
        const LogRow& row = diff.rows[i];
        if (sections.empty() || is_heading(row)) {
            sections.emplace_back();
            sections.back().is_of_shape =
                (row.mine ? *row.mine : *row.reference).find('{') != std::string::npos;
        }
        sections.back().text += lines(row);
        sections.back().differs |= row.differs;
        sections.back().is_first |= i == diff.first_row;
    }
    return sections;
}

/// The head of `lines` that has room, and the number of lines that have none.
int keep(std::string& kept, const std::string& lines, int& room) {
    int left_out = 0;
    for (const std::string& each : lines_of(lines)) {
        const std::string shown = wrapped(each);
        room -= 1 + int(std::count(shown.begin(), shown.end(), '\n'));
        if (room >= 0)
            kept += shown + "\n";
        else
            ++left_out;
    }
    return left_out;
}

}  // namespace

std::string text(const LogDiff& diff, const std::string& all) {
    std::string shown;
    for (const std::string& message : diff.unwritten) shown += tr_text(message) + "\n";
    if (diff.has_own_loop)
        shown += tr("Your trace tests shapes in a loop of its own, which logs nothing: the "
                    "reference's numbers for them are left out.") +
                 "\n";
    if (diff.first.empty()) return shown + tr("Nothing differs.") + "\n";
    constexpr int most = 24;
    int room = all.empty() ? std::numeric_limits<int>::max() : most;
    int left_out = 0;
    left_out += keep(shown, tr("The first difference: {what}", {{"what", diff.first}}), room);
    const std::vector<Section> sections = sections_of(diff);
    const bool answers_differ =
        std::any_of(sections.begin(), sections.end(),
                    [](const Section& each) { return each.is_first && each.is_of_shape; });
    if (!diff.hits_of_loop.empty() && !answers_differ) {
        left_out += keep(shown,
                         tr("Your loop gets the right answers from intersect. These are its hits, "
                            "the closest first, which is the one to be seen:"),
                         room);
        for (const std::string& hit : diff.hits_of_loop)
            left_out += keep(shown, "    " + shortened(hit), room);
    }
    for (const Section& each : sections)
        if (each.is_first) left_out += keep(shown, each.text, room);
    for (const Section& each : sections)
        if (each.differs && !each.is_first) left_out += keep(shown, each.text, room);
    if (left_out > 0)
        shown += tr("({number} more lines: {command})",
                    {{"number", std::to_string(left_out)}, {"command", all}}) +
                 "\n";
    return shown;
}

}  // namespace rt
