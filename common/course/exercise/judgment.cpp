#include "common/course/exercise/judgment.hpp"

#include "common/stages/reasons.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <utility>

namespace rt {

int Judged::passed() const {
    return int(std::ranges::count_if(suite.cases, &CaseResult::passed));
}

bool Judged::right() const {
    return suite.ended.empty() && !suite.cases.empty() && passed() == cases();
}

Judgment::Judgment(Judged double_result, std::optional<Judged> float_result)
    : in_double(std::move(double_result)), in_float(std::move(float_result)) {
    const auto& doubles = in_double.suite.cases;
    const auto& floats = in_float ? in_float->suite.cases : doubles;
    for (std::size_t i = 0; i < std::max(doubles.size(), floats.size()); ++i) {
        const std::string& name = i < doubles.size() ? doubles[i].name : floats[i].name;
        outcomes.push_back({i < doubles.size() ? doubles[i] : CaseResult{.name = name},
                            i < floats.size() ? floats[i] : CaseResult{.name = name}});
    }
}

bool Judgment::ended() const {
    return in_double.suite.ended.empty() && (!in_float || in_float->suite.ended.empty());
}

int Judgment::passed() const {
    return int(std::ranges::count_if(outcomes, &Outcome::passed));
}

int Judgment::cases() const {
    return std::max({int(outcomes.size()), in_double.cases(), in_float ? in_float->cases() : 0});
}

bool Judgment::right() const {
    return in_float && in_double.right() && in_float->right();
}

std::vector<std::string> unwritten_in(const std::string& output) {
    std::vector<std::string> names;
    for (const std::string& line : lines_of(output)) {
        const std::size_t end = line.find(not_written);
        if (end == std::string::npos) continue;
        const std::size_t before = line.rfind(' ', end - 1);  // "file:22: intersect is …"
        names.push_back(line.substr(before + 1, end - before - 1));
    }
    return names;
}

namespace {

/// The cases of one part, in the order of the suite.
struct Part {
    std::string name;
    std::vector<const Outcome*> cases;

    [[nodiscard]] int passed() const { return int(std::ranges::count_if(cases, &Outcome::passed)); }
    [[nodiscard]] bool right() const { return passed() == int(cases.size()); }
};

std::vector<Part> parts_of(const std::vector<Outcome>& all) {
    std::vector<Part> parts;
    for (const Outcome& outcome : all) {
        if (parts.empty() || parts.back().name != outcome.part())
            parts.push_back({.name = outcome.part()});
        parts.back().cases.push_back(&outcome);
    }
    return parts;
}

void show(const Outcome& outcome, const std::string& indent, bool is_given) {
    const char* mark = !outcome.passed() ? "✗ " : is_given ? "· " : "✓ ";
    const bool in_float_only = outcome.in_double.passed && !outcome.passed();
    const std::string line = wrapped(indent + mark + tr(outcome.in_double.name) +
                                     (in_float_only ? "  " + tr("(in float only)") : ""));
    print_line(styled(line, outcome.passed() ? Style::dim : Style::bad));
}

}  // namespace

void show_cases(const std::vector<Outcome>& all, const std::set<std::string>& given) {
    const std::vector<Part> parts = parts_of(all);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        const std::string line =
            (part.right() ? "  ✓ " : "  ✗ ") + std::to_string(i + 1) + " " +
            tr("{part}: {passed} of {cases}",
               {{"part", tr(part.name)}, {"passed", part.passed()}, {"cases", part.cases.size()}});
        if (parts.size() > 1) print_line(styled(line, part.right() ? Style::dim : Style::bad));
        for (const Outcome* each : part.cases)
            show(*each, parts.size() == 1 ? "  " : "      ",
                 each->passed() && given.count(each->in_double.name) == 1);
    }
    if (!given.empty()) print_line(styled("  · " + tr("passes unwritten too"), Style::dim));
}

}  // namespace rt
