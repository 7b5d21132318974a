// Ways off a surface: what they hit by mistake, and what they miss, at every size of a scene.
#include "docs/accuracy/chart.hpp"
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

#include <array>

namespace rt::accuracy {

namespace {

using namespace figures;

constexpr std::array colors = {green, ink, amber, red, blue, gray};

/// Of a million rays, over all shapes.
double share(const std::vector<Row>& rows, const std::string& column) {
    double all = 0;
    double counted = 0;
    for (const Row& row : rows) {
        all += number(row, "rays");
        counted += number(row, column);
    }
    return 1e6 * counted / all;
}

std::vector<Series> lines_of(const std::vector<Row>& rows, const std::string& column) {
    std::vector<Series> lines;
    for (const std::string& policy : different(rows, "policy")) {
        Series& series = lines.emplace_back(Series{policy, colors[lines.size()], {}});
        for (const std::string& size : different(rows, "size"))
            series.points.emplace_back(
                Real(std::stod(size)),
                Real(share(where(rows, {{"policy", policy}, {"size", size}}), column)));
    }
    return lines;
}

std::string plot(const std::vector<Row>& rows) {
    const auto precisions = different(rows, "precision");
    Svg svg({720, 26 + 200 * Real(precisions.size())},
            "Rays that leave a surface: false hits of itself, and occluders missed");
    for (std::size_t i = 0; i < precisions.size(); ++i) {
        const auto own = where(rows, {{"precision", precisions[i]}});
        for (const int column : {0, 1}) {
            const Scale x{.first = Real(1e-6),
                          .last = Real(1e6),
                          .ticks = decades(-6, 6, 3),
                          .title = "size of the scene"};
            Panel panel(
                svg, {.corner = {52 + 266 * Real(column), 40 + 200 * Real(i)}, .size = {220, 118}},
                x, of_a_million());
            const auto lines = lines_of(own, column == 0 ? "self hits" : "missed");
            panel.title(precisions[i] +
                        (column == 0 ? ": false self-hits of a million" : ": occluders missed"));
            if (column == 0) panel.write_y_ticks();
            draw(panel, lines);
            if (column == 1) name(svg, panel, lines);
        }
    }
    return svg.source();
}

std::string table(const std::vector<Row>& rows) {
    std::string text = "| | precision |";
    const std::array sizes = {"1e-06", "1", "1e+06"};
    for (const char* size : {"10⁻⁶", "1", "10⁶"})
        text += std::string(" size ") + size + ": self-hits, missed |";
    text += "\n|---|---|---|---|---|\n";
    for (const std::string& policy : different(rows, "policy"))
        for (const std::string& precision : different(rows, "precision")) {
            text += "| " + policy + " | " + precision + " |";
            for (const char* size : sizes) {
                const auto own =
                    where(rows, {{"policy", policy}, {"precision", precision}, {"size", size}});
                text += " " + thousands(share(own, "self hits")) + ", " +
                        thousands(share(own, "missed")) + " |";
            }
            text += "\n";
        }
    return text;
}

}  // namespace

Study contact(const std::filesystem::path& folder) {
    const auto rows = read_csv(folder / "contact.csv");
    return {.plots = {{"step10_shadows_contact", plot(rows)}},
            .tables = {{"contact", table(rows)}}};
}

}  // namespace rt::accuracy
