#include "common/course/exercise/log_text.hpp"

#include "common/system/paint.hpp"

namespace rt {

namespace {

std::string line(const std::string& whose, const std::string& words) {
    const std::string label = whose + std::string(10 - whose.size(), ' ');
    return (whose.empty() ? label : styled(label, Style::bold)) + words + "\n";
}

std::string lines(const LogRow& row) {
    if (!row.differs) return line("", *row.mine);
    return (row.mine ? line("mine", *row.mine) : "") +
           (row.reference ? line("reference", *row.reference) : "");
}

}  // namespace

std::string text(const LogDiff& diff) {
    std::string all;
    for (const std::string& message : diff.unwritten) all += message + "\n";
    if (diff.has_own_loop)
        all +=
            "Your trace tests shapes in a loop of its own, which logs nothing: the reference's "
            "numbers for them are left out.\n";
    if (diff.first.empty()) return all + "Nothing differs.\n";
    int equal = 0;
    for (auto row = diff.rows.begin(); row != diff.rows.end();) {
        std::string section;
        bool differs = false;
        do {
            section += lines(*row);
            differs = differs || row->differs;
        } while (++row != diff.rows.end() && !is_heading(*row));
        all += differs ? section : "";
        equal += differs ? 0 : 1;
    }
    if (equal > 0) all += "(equal sections left out: " + std::to_string(equal) + ")\n";
    return all + "\nThe first difference: " + diff.first + "\n";
}

}  // namespace rt
