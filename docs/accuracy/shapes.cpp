// The forms of intersecting each shape: what they cost, how far off they are, and what they get
// wrong.
#include "docs/accuracy/chart.hpp"
#include "docs/accuracy/csv.hpp"
#include "docs/accuracy/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace rt::accuracy {

namespace {

using namespace figures;

constexpr std::array stages = {
    std::pair{"sphere", "step03_sphere"},     std::pair{"plane", "step04_plane"},
    std::pair{"triangle", "step05_triangle"}, std::pair{"square", "step06_square"},
    std::pair{"cylinder", "step07_cylinder"}, std::pair{"cone", "step08_cone"},
};

/// One formula in one precision.
struct Form {
    std::string name;
    std::string precision;
    std::string_view color;
    double cost = 0;     ///< of a hit, times the textbook's form in double
    double miss = 0;     ///< of a miss, in the same unit
    double typical = 0;  ///< error of half the hits, at most, as a part of the largest coordinate
    double error = 0;    ///< of all but one hit in a thousand
    double wrong = 0;    ///< decisions, of a million
};

double wrong_of_a_million(const Row& row) {
    return 1e6 * number(row, "wrong") / number(row, "rays");
}

/// The reference's, the textbook's and the certified one's are the same for every shape; what comes
/// after the other right answers is a mistake.
std::string_view color_of(const std::string& name, std::size_t place) {
    if (name == "certified") return ink;
    constexpr std::array colors = {green, blue, amber, gray};
    return place < colors.size() ? colors[place] : red;
}

std::string label(const Form& form) {
    return form.precision == "exact" ? form.name : form.name + ", " + form.precision;
}

/// Whether the form's decisions stand beside those of this precision.
bool shown_with(const std::string& precision, const Form& form) {
    return form.precision == precision || (form.precision == "exact" && precision == "double");
}

class Shape {
public:
    Shape(const std::string& name, const std::vector<Row>& costs, const std::vector<Row>& errors)
        : name_(name),
          costs_(where(costs, {{"shape", name}})),
          errors_(where(errors, {{"shape", name}})) {
        const auto names = different(errors_, "form");
        for (const std::string& precision : different(errors_, "precision"))
            for (std::size_t i = 0; i < names.size(); ++i)
                if (const auto rows = where(
                        errors_, {{"form", names[i]}, {"precision", precision}, {"axis", "all"}});
                    !rows.empty())
                    forms_.push_back({.name = names[i],
                                      .precision = precision,
                                      .color = color_of(names[i], i),
                                      .cost = cost(names[i], precision, "hit", names[1]),
                                      .miss = cost(names[i], precision, "miss", names[1]),
                                      .typical = number(rows[0], "median"),
                                      .error = number(rows[0], "most"),
                                      .wrong = wrong_of_a_million(rows[0])});
    }

    [[nodiscard]] std::string cost_plot() const {
        Svg svg({640, 400}, "What the forms for a " + name_ + " cost, and how far off they are");
        Panel panel(svg, {.corner = {62, 46}, .size = {350, 296}},
                    {.first = Real(0.5),
                     .last = 16,
                     .ticks = values({0.5, 1, 2, 4, 8, 16}),
                     .title = "time of a hit, the textbook's form in double being 1"},
                    {.first = Real(1e-17), .last = 1, .ticks = decades(-16, 0, 4)});
        panel.write_y_ticks();
        panel.title("Error that one hit in a thousand exceeds, of the largest coordinate");
        std::vector<Label> labels;
        for (const Form& form : forms_) {
            const Vec2 point(Real(form.cost), Real(form.error));
            panel.mark(point, form.color, form.precision != "float");
            labels.push_back({panel(point), label(form), form.color});
        }
        write_labels(svg, labels, 452, 56, 340);
        return svg.source();
    }

    [[nodiscard]] std::string wrong_plot() const {
        const std::array precisions = {"float", "double"};
        const Real height = 200;
        Svg svg({720, 26 + height * Real(precisions.size())},
                "Wrong decisions for a " + name_ + " against distance, offset and grazing");
        for (std::size_t i = 0; i < precisions.size(); ++i)
            draw_wrong(svg, precisions[i], 40 + height * Real(i));
        return svg.source();
    }

    [[nodiscard]] std::string table() const {
        std::string text =
            "| | precision | a hit | a miss | typical error | one hit in 1000 exceeds | wrong of a "
            "million "
            "|\n"
            "|---|---|---|---|---|---|---|\n";
        for (const Form& form : forms_)
            text += "| " + form.name + " | " + form.precision + " | " + two_digits(form.cost) +
                    " | " + two_digits(form.miss) + " | " + power(form.typical) + " | " +
                    power(form.error) + " | " + thousands(form.wrong) + " |\n";
        return text;
    }

private:
    /// In units of a hit by the textbook's form in double. The quickest turns count: what others do
    /// on a machine makes turns longer, and one form's more than another's.
    [[nodiscard]] double cost(const std::string& form, const std::string& precision,
                              const std::string& rays, const std::string& textbook) const {
        return nanoseconds(form, precision, rays) / nanoseconds(textbook, "double", "hit");
    }

    [[nodiscard]] double nanoseconds(const std::string& form, const std::string& precision,
                                     const std::string& rays) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Row& row :
             where(costs_, {{"form", form}, {"precision", precision}, {"rays", rays}}))
            least = std::min(least, number(row, "nanoseconds"));
        return least;
    }

    void draw_wrong(Svg& svg, const std::string& precision, Real top) const {
        struct Axis {
            const char* word;
            const char* title;
            Scale scale;
        };
        const int lowest = precision == "float" ? -12 : -18;
        const std::array axes = {
            Axis{"distance",
                 "distance over size",
                 {.first = 1, .last = Real(1e8), .ticks = decades(0, 8, 4)}},
            Axis{"offset",
                 "offset over size",
                 {.first = 1, .last = Real(1e8), .ticks = decades(0, 8, 4)}},
            Axis{"grazing",
                 "grazing by",
                 {.first = std::pow(Real(10), Real(lowest)),
                  .last = Real(0.01),
                  .ticks = decades(lowest, -2, lowest == -18 ? 8 : 5)}},
        };
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const auto& [word, title, scale] = axes[i];
            Scale x = scale;
            x.title = title;
            Panel panel(svg, {.corner = {52 + 174 * Real(i), top}, .size = {140, 118}}, x,
                        of_a_million());
            if (i == 0) {
                panel.write_y_ticks();
                panel.title("Wrong decisions of a million, " + precision);
            }
            std::vector<Series> lines;
            for (const Form& form : forms_)
                if (shown_with(precision, form))
                    lines.push_back({form.name, form.color, wrong_along(word, form)});
            draw(panel, lines);
            if (i + 1 == axes.size()) name(svg, panel, lines);
        }
    }

    [[nodiscard]] std::vector<Vec2> wrong_along(const char* axis, const Form& form) const {
        std::vector<Vec2> points;
        for (const Row& row :
             where(errors_, {{"form", form.name}, {"precision", form.precision}, {"axis", axis}}))
            points.emplace_back(Real(number(row, "at")), Real(wrong_of_a_million(row)));
        return points;
    }

    std::string name_;
    std::vector<Row> costs_;
    std::vector<Row> errors_;
    std::vector<Form> forms_;
};

}  // namespace

Study shapes(const std::filesystem::path& folder) {
    const auto costs = read_csv(folder / "shape_costs.csv");
    const auto errors = read_csv(folder / "shape_errors.csv");
    Study study;
    for (const auto& [name, stage] : stages) {
        const Shape shape(name, costs, errors);
        study.plots.push_back({std::string(stage) + "_cost", shape.cost_plot()});
        study.plots.push_back({std::string(stage) + "_wrong", shape.wrong_plot()});
        study.tables.push_back({name, shape.table()});
    }
    return study;
}

}  // namespace rt::accuracy
