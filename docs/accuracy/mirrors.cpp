// Mirror upon mirror: the error of the picture and its time, against the depth.
#include "docs/accuracy/chart.hpp"
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

namespace rt::accuracy {

namespace {

using namespace figures;

/// The column against the depth; the time as a part of the last one's.
std::vector<Vec2> points_of(const std::vector<Row>& rows, const std::string& column, double unit) {
    std::vector<Vec2> points;
    for (const std::string& depth : different(rows, "depth"))
        points.emplace_back(std::stod(depth) + 1,
                            middle(where(rows, {{"depth", depth}}), column) / unit);
    return points;
}

/// The time of the picture whose mirrors end last.
double longest(const std::vector<Row>& rows) {
    return middle(where(rows, {{"depth", different(rows, "depth").back()}}), "seconds");
}

std::string plot(const std::vector<Row>& rows) {
    Svg svg({640, 250}, "Mirrors: the error of the picture and its time, against the depth");
    const std::vector<Tick> depths = {{1, "0"}, {2, "1"}, {3, "2"}, {5, "4"}, {9, "8"}, {17, "16"}};
    const Scale x{.first = 1, .last = 17, .ticks = depths, .title = "mirror upon mirror"};
    Panel errors(svg, {.corner = {62, 46}, .size = {240, 140}}, x,
                 {.first = Real(0.5),
                  .last = 64,
                  .ticks = {{Real(0.5), "0"}, {1, "1"}, {4, "4"}, {16, "16"}, {64, "64"}}});
    errors.title("Error in steps of 255");
    errors.write_y_ticks();
    Panel times(svg, {.corner = {372, 46}, .size = {240, 140}}, x,
                {.first = Real(0.25), .last = 2, .ticks = values({0.25, 0.5, 1, 2})});
    times.title("Time, of the whole picture's");
    times.write_y_ticks();
    for (const auto& [panel, column, unit, color] :
         {std::tuple{&errors, "error", 1.0, red}, {&times, "seconds", longest(rows), blue}}) {
        const std::vector<Series> line = {{column, color, points_of(rows, column, unit)}};
        draw(*panel, line);
        dot(*panel, line);
    }
    return svg.source();
}

std::string table(const std::vector<Row>& rows) {
    std::string text =
        "| depth | time | error | largest error | pixels off by more than 2 steps |\n"
        "|---|---|---|---|---|\n";
    for (const std::string& depth : different(rows, "depth")) {
        const auto turns = where(rows, {{"depth", depth}});
        const Row& row = turns.front();
        text += "| " + depth + " | " + two_digits(middle(turns, "seconds") / longest(rows)) +
                " | " + two_digits(number(row, "error")) + " | " + row.at("most") + " | " +
                two_digits(100 * number(row, "seen")) + " % |\n";
    }
    return text;
}

}  // namespace

Study mirrors(const std::filesystem::path& folder) {
    const auto rows = read_csv(folder / "mirrors.csv");
    return {.plots = {{"step12_mirror_depth", plot(rows)}}, .tables = {{"mirrors", table(rows)}}};
}

}  // namespace rt::accuracy
