#include "common/course/exercise/trace_mistakes.hpp"

#include "common/system/files.hpp"

#include <map>

namespace rt {

namespace {

/// By the name of a failing case: the digest of all its failures.
using Failures = std::map<std::string, std::string>;

Failures failures_in(const std::vector<CaseResult>& cases) {
    Failures failures;
    for (const CaseResult& each : cases)
        if (!each.passed && !each.name.starts_with("the picture"))
            failures[each.name] = each.failures;
    return failures;
}

}  // namespace

std::optional<TraceMistake> recognized_trace_mistake(const std::filesystem::path& file,
                                                     const std::vector<CaseResult>& cases) {
    const Failures failures = failures_in(cases);
    if (failures.empty() || !std::filesystem::exists(file)) return std::nullopt;
    // A mistake's lines: "mistake name: sentence", then "digest case" for each failing case.
    constexpr std::size_t digits = 16;
    std::optional<TraceMistake> mistake;
    Failures of_mistake;
    for (const std::string& line : lines_of(read_text(file))) {
        if (line.starts_with("#")) continue;
        if (!line.starts_with("mistake ")) {
            of_mistake[line.substr(digits + 1)] = line.substr(0, digits);
            continue;
        }
        if (of_mistake == failures) return mistake;
        const std::size_t colon = line.find(": ");
        mistake = {.name = line.substr(8, colon - 8), .sentence = line.substr(colon + 2)};
        of_mistake.clear();
    }
    return of_mistake == failures ? mistake : std::nullopt;
}

}  // namespace rt
