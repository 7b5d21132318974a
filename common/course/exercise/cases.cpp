#include "common/course/exercise/cases.hpp"

#include "common/system/paint.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <cstdio>

namespace rt {

namespace {

/// The cases of one part, in the order of the suite.
struct Part {
    std::string name;
    std::vector<const Outcome*> cases;

    [[nodiscard]] int passed() const {
        return int(std::count_if(cases.begin(), cases.end(),
                                 [](const Outcome* each) { return each->passed(); }));
    }
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
    std::printf("%s\n", styled(line, outcome.passed() ? Style::dim : Style::bad).c_str());
}

}  // namespace

void show_cases(const std::vector<Outcome>& all, const std::set<std::string>& given) {
    const std::vector<Part> parts = parts_of(all);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        const std::string line =
            (part.right() ? "  ✓ " : "  ✗ ") + std::to_string(i + 1) + " " +
            tr("{part}: {passed} of {cases}", {{"part", tr(part.name)},
                                               {"passed", std::to_string(part.passed())},
                                               {"cases", std::to_string(part.cases.size())}});
        if (parts.size() > 1)
            std::printf("%s\n", styled(line, part.right() ? Style::dim : Style::bad).c_str());
        for (const Outcome* each : part.cases)
            show(*each, parts.size() == 1 ? "  " : "      ",
                 each->passed() && given.count(each->in_double.name) == 1);
    }
    if (!given.empty())
        std::printf("%s\n", styled("  · " + tr("passes unwritten too"), Style::dim).c_str());
}

}  // namespace rt
