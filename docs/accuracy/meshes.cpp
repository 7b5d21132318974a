// Meshes: fewer triangles, and many shapes: a list, in balls, and in a hierarchy.
#include "docs/accuracy/chart.hpp"
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

#include <algorithm>
#include <iterator>

namespace rt::accuracy {

namespace {

using namespace figures;

std::vector<Vec2> points_of(const std::vector<Row>& rows, const std::string& x,
                            const std::string& y, double unit = 1) {
    std::vector<Vec2> points;
    for (const std::string& value : different(rows, x))
        points.emplace_back(std::stod(value), middle(where(rows, {{x, value}}), y) / unit);
    return points;
}

/// No balls are around more shapes than so many.
bool in_balls(const Row& row) {
    return !row.at("balls").empty();
}

std::string hierarchy_plot(const std::vector<Row>& rows) {
    std::vector<Row> few;
    std::ranges::copy_if(rows, std::back_inserter(few), in_balls);
    Svg svg({640, 320}, "The nearest of many spheres: a list, in balls, and in a hierarchy");
    Panel panel(svg, {.corner = {62, 46}, .size = {420, 216}},
                {.first = 1,
                 .last = 512,
                 .ticks = values({1, 2, 4, 8, 16, 32, 64, 128, 256, 512}),
                 .title = "spheres"},
                {.first = 2, .last = 5000, .ticks = values({10, 100, 1000})});
    panel.title("Nanoseconds a ray");
    panel.write_y_ticks();
    const std::vector<Series> lines = {
        {"list", red, points_of(rows, "spheres", "list")},
        {"balls", blue, points_of(few, "spheres", "balls")},
        {"hierarchy", green, points_of(rows, "spheres", "hierarchy")}};
    draw(panel, lines);
    dot(panel, lines);
    name(svg, panel, lines);
    return svg.source();
}

std::string hierarchy_table(const std::vector<Row>& rows) {
    std::string text =
        "| spheres | list, ns | in balls, ns | in a hierarchy, ns |\n|---|---|---|---|\n";
    for (const std::string& count : different(rows, "spheres")) {
        const auto turns = where(rows, {{"spheres", count}});
        const std::string balls = in_balls(turns.front()) ? two_digits(middle(turns, "balls")) : "";
        text += "| " + count + " | " + two_digits(middle(turns, "list")) + " | " + balls + " | " +
                two_digits(middle(turns, "hierarchy")) + " |\n";
    }
    return text;
}

double whole_time(const std::vector<Row>& rows) {
    return middle(where(rows, {{"triangles", rows.front().at("triangles")}}), "seconds");
}

std::string decimation_plot(const std::vector<Row>& rows) {
    Svg svg({640, 250}, "A mesh with fewer triangles: other pixels, and time");
    const Scale x{.first = 64,
                  .last = 10000,
                  .ticks = values({100, 300, 1000, 3000, 10000}),
                  .title = "triangles"};
    Panel pixels(
        svg, {.corner = {62, 46}, .size = {240, 140}}, x,
        {.first = Real(0.01),
         .last = 1,
         .ticks = {
             {Real(0.01), "0"}, {Real(0.03), "3 %"}, {Real(0.1), "10 %"}, {Real(0.3), "30 %"}}});
    pixels.title("Pixels off by more than 2 steps");
    pixels.write_y_ticks();
    Panel times(svg, {.corner = {372, 46}, .size = {240, 140}}, x,
                {.first = Real(0.25), .last = 2, .ticks = values({0.25, 0.5, 1, 2})});
    times.title("Time, of the whole mesh's");
    times.write_y_ticks();
    for (const auto& [panel, column, unit, color] :
         {std::tuple{&pixels, "seen", 1.0, red}, {&times, "seconds", whole_time(rows), blue}}) {
        const std::vector<Series> line = {
            {column, color, points_of(rows, "triangles", column, unit)}};
        draw(*panel, line);
        dot(*panel, line);
    }
    return svg.source();
}

std::string decimation_table(const std::vector<Row>& rows) {
    std::string text =
        "| triangles | time | error | pixels off by more than 2 steps |\n"
        "|---|---|---|---|\n";
    for (const std::string& triangles : different(rows, "triangles")) {
        const auto turns = where(rows, {{"triangles", triangles}});
        text += "| " + thousands(std::stod(triangles)) + " | " +
                two_digits(middle(turns, "seconds") / whole_time(rows)) + " | " +
                two_digits(number(turns.front(), "error")) + " | " +
                two_digits(100 * number(turns.front(), "seen")) + " % |\n";
    }
    return text;
}

}  // namespace

Study meshes(const std::filesystem::path& folder) {
    const auto hierarchy = read_csv(folder / "hierarchy.csv");
    const auto decimation = read_csv(folder / "decimation.csv");
    return {.plots = {{"step13_meshes_hierarchy", hierarchy_plot(hierarchy)},
                      {"step13_meshes_decimation", decimation_plot(decimation)}},
            .tables = {{"hierarchy", hierarchy_table(hierarchy)},
                       {"decimation", decimation_table(decimation)}}};
}

}  // namespace rt::accuracy
