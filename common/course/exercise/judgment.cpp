#include "common/course/exercise/judgment.hpp"

#include "common/stages/not_written.hpp"
#include "common/system/files.hpp"

#include <algorithm>
#include <utility>

namespace rt {

int Judged::passed() const {
    return int(std::count_if(suite.cases.begin(), suite.cases.end(),
                             [](const CaseResult& result) { return result.passed; }));
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
    return int(std::count_if(outcomes.begin(), outcomes.end(),
                             [](const Outcome& outcome) { return outcome.passed(); }));
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

}  // namespace rt
