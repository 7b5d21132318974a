// Shadows of a light with a size: the error against the time, for each way of spreading its rays.
#include "docs/accuracy/chart.hpp"
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

#include <array>
#include <cmath>

namespace rt::accuracy {

namespace {

using namespace figures;

constexpr std::array colors = {red, amber, green, blue};

/// How often a shadow ray must be sent to halve the error, as a power: the slope of the straight
/// line that fits best in both logarithms, of the error against the rays.
double slope(const std::vector<Row>& rows) {
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    for (const Row& row : rows) {
        const double rays = std::log(number(row, "rays"));
        const double error = std::log(number(row, "error"));
        x += rays;
        y += error;
        xx += rays * rays;
        xy += rays * error;
    }
    const auto count = double(rows.size());
    return (count * xy - x * y) / (count * xx - x * x);
}

std::vector<Series> lines_of(const std::vector<Row>& rows) {
    std::vector<Series> lines;
    for (const std::string& way : different(rows, "way")) {
        Series& series = lines.emplace_back(Series{way, colors[lines.size()], {}});
        const auto own = where(rows, {{"way", way}});
        for (const std::string& asked : different(own, "asked")) {
            const auto turns = where(own, {{"asked", asked}});
            series.points.emplace_back(Real(middle(turns, "microseconds")),
                                       Real(number(turns.front(), "error")));
        }
    }
    return lines;
}

std::string plot(const std::vector<Row>& rows) {
    Svg svg({640, 360}, "Soft shadows: the error against the time, for four ways of sampling");
    Panel panel(svg, {.corner = {62, 46}, .size = {400, 256}},
                {.first = Real(0.1),
                 .last = 1000,
                 .ticks = values({0.1, 1, 10, 100, 1000}),
                 .title = "microseconds a surface"},
                {.first = Real(0.05), .last = 20, .ticks = values({0.1, 1, 10})});
    panel.title("Error of a colour in steps of 255, root mean square");
    panel.write_y_ticks();
    const auto lines = lines_of(rows);
    draw(panel, lines);
    dot(panel, lines);
    name(svg, panel, lines);
    return svg.source();
}

std::string table(const std::vector<Row>& rows) {
    std::string text =
        "| | rays | microseconds | error | largest error | slope |\n"
        "|---|---|---|---|---|---|\n";
    for (const std::string& way : different(rows, "way")) {
        const auto own = where(rows, {{"way", way}});
        std::string all_over = decimal(Real(slope(own)), 2);
        for (const std::string& asked : different(own, "asked")) {
            const auto turns = where(own, {{"asked", asked}});
            const Row& row = turns.front();
            text += "| " + way + (way == "adaptive" ? ", to 1/" + asked : "") + " | " +
                    two_digits(number(row, "rays")) + " | " +
                    two_digits(middle(turns, "microseconds")) + " | " +
                    two_digits(number(row, "error")) + " | " + two_digits(number(row, "most")) +
                    " | " + all_over + " |\n";
            all_over.clear();
        }
    }
    return text;
}

}  // namespace

Study penumbra(const std::filesystem::path& folder) {
    const auto rows = read_csv(folder / "penumbra.csv");
    return {.plots = {{"step11_soft_shadows_error", plot(rows)}},
            .tables = {{"penumbra", table(rows)}}};
}

}  // namespace rt::accuracy
