#include "common/course/exercise/log_diff.hpp"

#include "common/course/exercise/failure_text.hpp"
#include "common/stages/reasons.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace rt {

namespace {

using Lines = std::vector<std::string>;

constexpr double rounding = 1e-5;        // between two right formulas, in float and in double
constexpr double of_rounding = 0.01;     // a smaller number has the rounding of this one
constexpr double near_the_light = 5e-4;  // the end of a shadow ray: 0.9999 is as right as 1 − 1e-14
constexpr std::size_t most_lines = 2000;  // a scene with more shapes logs no more of its misses

/// True if two texts are equal up to the last digits of their numbers.
bool same(const std::string& a, const std::string& b, double tolerance = rounding) {
    const char* p = a.c_str();
    const char* q = b.c_str();
    while (*p != '\0' && *q != '\0') {
        char* after_p = nullptr;
        char* after_q = nullptr;
        const double x = std::strtod(p, &after_p);
        const double y = std::strtod(q, &after_q);
        if (after_p != p && after_q != q) {
            const double size = std::max({std::abs(x), std::abs(y), of_rounding});
            const bool close = x == y || (std::isnan(x) && std::isnan(y)) ||
                               (std::isfinite(size) && std::abs(x - y) <= tolerance * size);
            if (!close) return false;
            p = after_p;
            q = after_q;
        } else if (*p++ != *q++) {
            return false;
        }
    }
    return *p == *q;
}

constexpr const char* verdict = "→";  // precedes a result: a hit, a miss

/// The text with "#" for each number.
std::string without_numbers(const std::string& line) {
    std::string text;
    for (const char* p = line.c_str(); *p != '\0';) {
        char* after = nullptr;
        std::strtod(p, &after);
        text += after == p ? *p : '#';
        p = after == p ? p + 1 : after;
    }
    return text;
}

/// The name of a line's quantity: "t" in "  t = 4"; in a line without one, all but its numbers, or
/// if it is a shape's, "Sphere{…}", all.
std::string name(const std::string& line) {
    if (!line.starts_with(' ') && line.find('{') != std::string::npos) return line;
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    if (line.compare(start, std::string(verdict).size(), verdict) == 0) return verdict;
    const std::size_t end = line.find(" = ");
    return end == std::string::npos ? without_numbers(line.substr(start))
                                    : line.substr(start, end - start);
}

Lines names_of(const Lines& lines) {
    Lines all;
    for (const std::string& line : lines) all.push_back(name(line));
    return all;
}

/// For each pair of tails, the number of lines with common names, in order.
std::vector<std::vector<int>> common_tails(const Lines& a, const Lines& b) {
    std::vector<std::vector<int>> longest(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = a.size(); i-- > 0;)
        for (std::size_t j = b.size(); j-- > 0;)
            longest[i][j] = a[i] == b[j] ? longest[i + 1][j + 1] + 1
                                         : std::max(longest[i + 1][j], longest[i][j + 1]);
    return longest;
}

/// Removes the messages about functions that are not written yet, and returns them, each once.
std::vector<std::string> take_unwritten(Lines& lines) {
    std::vector<std::string> taken;
    std::erase_if(lines, [&taken](const std::string& line) {
        if (line.find(not_written) == std::string::npos) return false;
        if (std::ranges::find(taken, line) == taken.end()) taken.push_back(line);
        return true;
    });
    return taken;
}

bool starts_section(const std::string& line) {
    return !line.starts_with(' ');
}

/// True for the first line of a section that ClosestHit writes: "Sphere{.center = …".
bool is_about_shapes(const std::string& line) {
    return starts_section(line) && (line.find('{') != std::string::npos ||
                                    line.starts_with("a mesh of ") || line == "The closest hit");
}

bool is_closest_hit(const std::string& line) {
    return line == "The closest hit";
}

template <class Kind>
Lines without_sections(const Lines& log, const Kind& is_one) {
    Lines others;
    bool left_out = false;
    for (const std::string& line : log) {
        if (starts_section(line)) left_out = is_one(line);
        if (!left_out) others.push_back(line);
    }
    return others;
}

const std::string& either(const LogRow& row) {
    return row.mine ? *row.mine : *row.reference;
}

/// In a section that both explanations have. A student's trace may do without one that explains
/// itself, so that the other has a section more: it is named if nothing else differs, or if it is
/// of a shape that a loop of the student's does not test.
void find_first_difference(LogDiff& diff, Writer writer) {
    std::string heading;
    bool is_common = true;
    for (std::size_t i = 0; i < diff.rows.size(); ++i) {
        const LogRow& row = diff.rows[i];
        if (is_heading(row)) {
            heading = either(row);
            is_common = row.mine && row.reference;
        }
        if (!row.differs) continue;
        if (is_common) {
            const std::string what = name(either(row));
            const std::string own = what == verdict ? tr("the result") : tr_text(what);
            diff.first = is_heading(row) ? tr_text(heading)
                                         : tr("{what}, of {heading}",
                                              {{"what", own}, {"heading", tr_text(heading)}});
            diff.first_row = i;
            return;
        }
        if (!diff.first.empty()) continue;
        const bool is_left_out =
            writer == Writer::own_loop && !row.mine && is_about_shapes(heading);
        const Values values = {{"heading", tr_text(heading)}};
        diff.first = is_left_out ? tr("{heading}, which your loop does not test", values)
                     : row.mine
                         ? tr("{heading}, which only your explanation has", values)
                         : tr("{heading}, which only the reference's explanation has", values);
        diff.first_row = i;
        if (is_left_out) return;
    }
}

/// The t in "→ hit at t = 4" and in "→ not nearer: a hit at t = 4, behind …".
std::string t_of_hit(const std::string& line) {
    const std::size_t start = line.find("hit at t = ");
    return start == std::string::npos
               ? line
               : line.substr(start, line.find_first_of(",a(", start + 11) - start);
}

/// Tests of a shape with two intervals can have two answers.
void ignore_intervals(std::vector<LogRow>& rows) {
    bool other_interval = false;
    for (LogRow& row : rows) {
        if (is_heading(row)) other_interval = false;
        if (name(either(row)) == "interval") {
            other_interval = other_interval || row.differs;
            row.may_differ = row.differs;
        }
        if (row.differs && name(either(row)) == "the shadow ray's interval" && row.mine &&
            row.reference)
            row.may_differ = same(*row.mine, *row.reference, near_the_light);
        if (row.differs && other_interval && row.mine && row.reference)
            row.may_differ = same(t_of_hit(*row.mine), t_of_hit(*row.reference));
        row.differs = row.differs && !row.may_differ;
    }
}

std::vector<std::string> hits_in(const Lines& log) {
    const std::string hit = "→ hit at t = ";
    std::vector<std::pair<double, std::string>> hits;
    std::string heading;
    for (const std::string& line : log) {
        if (starts_section(line)) heading = line;
        const std::size_t at = line.find(hit);
        if (at == std::string::npos) continue;
        const std::string number = line.substr(at + hit.size());
        hits.emplace_back(std::strtod(number.c_str(), nullptr),
                          "t = " + number.substr(0, number.find(' ')) + ": " + heading);
    }
    std::ranges::stable_sort(hits, {}, &std::pair<double, std::string>::first);
    std::vector<std::string> texts;
    for (const auto& [t, text] : hits) texts.push_back(text);
    return texts;
}

}  // namespace

bool is_heading(const LogRow& row) {
    return starts_section(either(row));
}

LogDiff compare_logs(const std::string& mine, const std::string& reference, Writer writer) {
    Lines a = lines_of(mine);
    Lines b = lines_of(reference);
    LogDiff diff{.rows = {}, .first = "", .unwritten = take_unwritten(a)};
    diff.has_own_loop =
        std::ranges::any_of(b, is_about_shapes) && std::ranges::none_of(a, is_about_shapes);
    if (diff.has_own_loop) b = without_sections(b, is_about_shapes);
    if (writer == Writer::own_loop) {
        b = without_sections(b, is_closest_hit);
        diff.hits_of_loop = hits_in(a);
    }
    a.resize(std::min(a.size(), most_lines));
    b.resize(std::min(b.size(), most_lines));
    const Lines a_names = names_of(a);
    const Lines b_names = names_of(b);
    const auto longest = common_tails(a_names, b_names);
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
        const bool left = i < a.size();
        const bool right = j < b.size();
        if (left && right && a_names[i] == b_names[j]) {
            diff.rows.push_back({a[i], b[j], !same(a[i], b[j])});
            ++i, ++j;
        } else if (left && (!right || longest[i + 1][j] >= longest[i][j + 1])) {
            diff.rows.push_back({a[i++], {}, true});
        } else {
            diff.rows.push_back({{}, b[j++], true});
        }
    }
    ignore_intervals(diff.rows);
    find_first_difference(diff, writer);
    return diff;
}

std::string value_in_log(const std::string& log, const std::string& name) {
    std::string value;
    for (const std::string& line : lines_of(log)) {
        const std::size_t start = line.find_first_not_of(' ');
        if (start != std::string::npos && line.substr(start).starts_with(name + " = "))
            value = line.substr(start + name.size() + 3);
    }
    return value;
}

namespace {

std::string line(const std::string& whose, const std::string& words) {
    constexpr std::size_t columns = 10;
    const std::string label =
        whose + std::string(columns - std::min(columns_of(whose), columns), ' ');
    return (whose.empty() ? label : styled(label, Style::bold)) + words + "\n";
}

constexpr int digits_shown = 7;

/// With fewer digits, and the names of quantities in the reader's language.
std::string shortened(const std::string& text) {
    return tr_line(with_digits(text, digits_shown));
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
            sections.back().is_of_shape = either(row).find('{') != std::string::npos;
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
        room -= 1 + int(std::ranges::count(shown, '\n'));
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
    const std::string first = with_digits(diff.first, digits_shown);
    left_out += keep(shown, tr("The first difference: {what}", {{"what", first}}), room);
    const std::vector<Section> sections = sections_of(diff);
    const bool answers_differ = std::ranges::any_of(
        sections, [](const Section& each) { return each.is_first && each.is_of_shape; });
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
        shown +=
            tr("({number} more lines: {command})", {{"number", left_out}, {"command", all}}) + "\n";
    return shown;
}

}  // namespace rt
