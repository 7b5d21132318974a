// What float and double lose of a scene that is moved, scaled, or has a small gap in it.
#include "docs/accuracy/chart.hpp"
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

#include <array>
#include <cmath>

namespace rt::accuracy {

namespace {

using namespace figures;

struct Change {
    const char* word;
    Scale scale;
    std::array<int, 2> decades;  ///< of the table: the first and the last power of ten
};

std::array<Change, 3> changes() {
    return {
        Change{"moved",
               {.first = 10, .last = Real(1e12), .ticks = decades(2, 10, 4), .title = "moved by"},
               {2, 10}},
        Change{"scaled",
               {.first = Real(1e-12),
                .last = Real(1e12),
                .ticks = decades(-9, 9, 9),
                .title = "scaled by"},
               {-12, 12}},
        Change{"gap",
               {.first = Real(1e-16),
                .last = Real(0.1),
                .ticks = decades(-14, -2, 6),
                .title = "gap between two squares"},
               {-9, -1}}};
}

std::vector<Series> lines_of(const std::vector<Row>& rows) {
    std::vector<Series> lines;
    for (const auto& [precision, color] : {std::pair{"float", red}, std::pair{"double", green}}) {
        Series& series = lines.emplace_back(Series{precision, color, {}});
        for (const Row& row : where(rows, {{"precision", precision}}))
            series.points.emplace_back(Real(number(row, "at")), Real(1e6 * number(row, "seen")));
    }
    return lines;
}

std::string plot(const std::vector<Row>& rows) {
    Svg svg({720, 226}, "Pixels that a scene loses when it is moved, scaled, or has a small gap");
    Real left = 52;
    for (const auto& [word, scale, shown] : changes()) {
        Panel panel(svg, {.corner = {left, 40}, .size = {140, 118}}, scale, of_a_million());
        const auto lines = lines_of(where(rows, {{"change", word}}));
        draw(panel, lines);
        if (left == 52) {
            panel.write_y_ticks();
            panel.title("Pixels of a million that are off by more than 2 steps");
        }
        left += 174;
        if (left > 52 + 2 * 174) name(svg, panel, lines);
    }
    return svg.source();
}

/// A change's values from left to right, and below them what each precision loses.
std::string table(const std::vector<Row>& rows, const Change& change) {
    const auto own = where(rows, {{"change", change.word}});
    std::string head = "| " + change.scale.title;
    std::string rule = "|---";
    std::string in_float = "| float";
    std::string in_double = "| double";
    for (const std::string& at : different(own, "at")) {
        const int decade = int(std::lround(std::log10(std::stod(at))));
        if (decade < change.decades[0] || decade > change.decades[1]) continue;
        const auto lost = [&](const char* precision) {
            const Real share = middle(where(own, {{"at", at}, {"precision", precision}}), "seen");
            return " | " + two_digits(100 * share) + " %";
        };
        head += " | " + power_of_ten(decade);
        rule += "|---";
        in_float += lost("float");
        in_double += lost("double");
    }
    return head + " |\n" + rule + "|\n" + in_float + " |\n" + in_double + " |\n";
}

std::string tables(const std::vector<Row>& rows) {
    std::string text;
    for (const Change& change : changes()) text += (text.empty() ? "" : "\n") + table(rows, change);
    return text;
}

}  // namespace

Study input_rounding(const std::filesystem::path& folder) {
    const auto rows = read_csv(folder / "input_rounding.csv");
    return {.plots = {{"input_rounding", plot(rows)}},
            .tables = {{"input rounding", tables(rows)}}};
}

}  // namespace rt::accuracy
