#include "common/course/exercise/log_diff.hpp"

#include "common/system/files.hpp"
#include "common/system/paint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rt {

namespace {

using Lines = std::vector<std::string>;

constexpr double rounding = 1e-5;  // between two right formulas, in float and in double

/// True if two texts are equal up to the last digits of their numbers.
bool same(const std::string& a, const std::string& b) {
    const char* p = a.c_str();
    const char* q = b.c_str();
    while (*p != '\0' && *q != '\0') {
        char* after_p = nullptr;
        char* after_q = nullptr;
        const double x = std::strtod(p, &after_p);
        const double y = std::strtod(q, &after_q);
        if (after_p != p && after_q != q) {
            const double size = std::max({std::abs(x), std::abs(y), 1.0});
            const bool close =
                x == y || std::abs(x - y) <= rounding * size || (std::isnan(x) && std::isnan(y));
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

/// The name of a line's quantity: "t" in "  t = 4".
std::string name(const std::string& line) {
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    if (line.compare(start, std::string(verdict).size(), verdict) == 0) return verdict;
    return line.substr(start, line.find(" = ") - start);
}

/// For each pair of tails, the number of lines with common names, in order.
std::vector<std::vector<int>> common_tails(const Lines& a, const Lines& b) {
    std::vector<std::vector<int>> longest(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = a.size(); i-- > 0;)
        for (std::size_t j = b.size(); j-- > 0;)
            longest[i][j] = name(a[i]) == name(b[j])
                                ? longest[i + 1][j + 1] + 1
                                : std::max(longest[i + 1][j], longest[i][j + 1]);
    return longest;
}

/// The output, section by section, without equal sections.
class Page {
public:
    void both(const std::string& line) { add("          ", line); }
    void mine(const std::string& line) { differ("mine      ", line); }
    void reference(const std::string& line) { differ("reference ", line); }

    [[nodiscard]] std::string text() {
        end_section();
        if (first_.empty()) return "Nothing differs.\n";
        if (alike_ > 0) text_ += "(" + std::to_string(alike_) + " equal sections are left out)\n";
        return text_ + "\nThe first difference: " + first_ + "\n";
    }

private:
    void add(const std::string& whose, const std::string& line) {
        if (line.rfind(' ', 0) != 0) {  // a heading
            end_section();
            heading_ = line;
        }
        section_ += whose + line + "\n";
    }

    void differ(const std::string& whose, const std::string& line) {
        add(styled(whose, Style::bold), line);
        differs_ = true;
        if (!first_.empty()) return;
        first_ = (name(line) == verdict ? "the result" : name(line)) + ", of " + heading_;
    }

    void end_section() {
        if (differs_)
            text_ += section_;
        else if (!section_.empty())
            ++alike_;
        section_.clear();
        differs_ = false;
    }

    std::string text_;
    std::string section_;
    std::string heading_;
    std::string first_;
    bool differs_ = false;
    int alike_ = 0;
};

}  // namespace

std::string beside(const std::string& mine, const std::string& reference) {
    constexpr std::size_t most =
        2000;  // lines; a scene with more shapes logs no more of its misses
    Lines a = lines_of(mine);
    Lines b = lines_of(reference);
    a.resize(std::min(a.size(), most));
    b.resize(std::min(b.size(), most));
    const auto longest = common_tails(a, b);
    Page page;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
        const bool pair = i < a.size() && j < b.size() && name(a[i]) == name(b[j]);
        if (pair && same(a[i], b[j])) {
            page.both(a[i]);
            ++i, ++j;
        } else if (pair) {
            page.mine(a[i++]);
            page.reference(b[j++]);
        } else if (i < a.size() && (j == b.size() || longest[i + 1][j] >= longest[i][j + 1])) {
            page.mine(a[i++]);
        } else {
            page.reference(b[j++]);
        }
    }
    return page.text();
}

}  // namespace rt
