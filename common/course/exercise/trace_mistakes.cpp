#include "common/course/exercise/trace_mistakes.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace rt {

namespace {

/// By the digest of a question that was answered wrongly: the digest of the answer.
using Failures = std::map<std::string, std::string>;

void add_failures(const std::string& digests, Failures& failures) {
    constexpr std::size_t digits = 8;
    for (const std::string& each : words_of(digests))
        failures[each.substr(0, digits)] = each.substr(digits);
}

struct KnownTrace {
    std::string name;
    std::string sentence;
    Failures failures;
};

/// A mistake's lines: "mistake name: sentence", then the digests of its failures.
std::vector<KnownTrace> known_in(const std::string& text) {
    std::vector<KnownTrace> known;
    for (const std::string& line : lines_of(text)) {
        if (line.starts_with("#")) continue;
        if (!line.starts_with("mistake ")) {
            if (!known.empty()) add_failures(line, known.back().failures);
            continue;
        }
        const std::size_t colon = line.find(": ");
        known.push_back({line.substr(8, colon - 8), line.substr(colon + 2), {}});
    }
    return known;
}

/// The number of questions that both fail, with the same wrong answer.
std::size_t in_common(const Failures& a, const Failures& b) {
    return std::size_t(std::ranges::count_if(a, [&](const auto& failure) {
        const auto found = b.find(failure.first);
        return found != b.end() && found->second == failure.second;
    }));
}

/// A mistake is likely if it explains all failures, or causes them and some others besides, which
/// come from an independent detail: few are left on either side.
bool is_likely(std::size_t common, std::size_t failures, std::size_t of_mistake) {
    constexpr std::size_t least = 5;
    constexpr double most_left = 0.25;
    return common >= least && (common == failures || common == of_mistake) &&
           double(failures + of_mistake - 2 * common) <= most_left * double(common);
}

/// The known mistake with the fewest failures that are not the trace's, or the other way round.
std::optional<TraceMistake> the_one(const std::vector<KnownTrace>& known,
                                    const Failures& failures) {
    const KnownTrace* best = nullptr;
    std::size_t least_left = 0;
    for (const KnownTrace& each : known) {
        const std::size_t common = in_common(failures, each.failures);
        const std::size_t left = failures.size() + each.failures.size() - 2 * common;
        if (left != 0 && !is_likely(common, failures.size(), each.failures.size())) continue;
        if (best != nullptr && left >= least_left) continue;
        best = &each;
        least_left = left;
    }
    if (best == nullptr) return std::nullopt;
    return TraceMistake{
        .name = best->name, .sentence = best->sentence, .is_certain = least_left == 0};
}

/// Returns whether both mistakes together explain all failures: each some that the other one does
/// not, and nearly all that it alone causes. To a question that both fail, any answer is accepted.
bool explain_together(const KnownTrace& a, const KnownTrace& b, const Failures& failures) {
    constexpr int least_alone = 3;
    constexpr double most_missing = 0.25;
    const auto explains = [&failures](const KnownTrace& known, const KnownTrace& other) {
        int alone = 0;
        int missing = 0;
        for (const auto& [question, answer] : known.failures) {
            if (other.failures.contains(question)) continue;
            const auto found = failures.find(question);
            ++(found != failures.end() && found->second == answer ? alone : missing);
        }
        return alone >= least_alone && missing <= most_missing * alone;
    };
    const auto is_of = [](const KnownTrace& known, const auto& failure) {
        const auto found = known.failures.find(failure.first);
        return found != known.failures.end() && found->second == failure.second;
    };
    return std::ranges::all_of(
               failures,
               [&](const auto& each) {
                   return is_of(a, each) || is_of(b, each) ||
                          (a.failures.contains(each.first) && b.failures.contains(each.first));
               }) &&
           explains(a, b) && explains(b, a);
}

/// The only two known mistakes that explain all failures together; nothing if others do, too.
std::vector<TraceMistake> the_two(const std::vector<KnownTrace>& known, const Failures& failures) {
    std::vector<TraceMistake> found;
    for (auto a = known.begin(); a != known.end(); ++a)
        for (auto b = known.begin(); b != a; ++b) {
            if (a->sentence == b->sentence || !explain_together(*a, *b, failures)) continue;
            const std::set<std::string> sentences = {a->sentence, b->sentence};
            if (!found.empty() && sentences != std::set{found[0].sentence, found[1].sentence})
                return {};
            if (found.empty())
                for (const KnownTrace& each : {*b, *a})
                    found.push_back({each.name, each.sentence, false});
        }
    return found;
}

}  // namespace

std::vector<TraceMistake> recognized_trace_mistakes(const fs::path& file,
                                                    const std::vector<CaseResult>& cases) {
    Failures failures;
    for (const CaseResult& each : cases)
        if (!each.passed && !each.name.starts_with("the picture"))
            add_failures(each.failures, failures);
    if (failures.empty() || !fs::exists(file)) return {};
    const std::vector<KnownTrace> known = known_in(read_text(file));
    const std::optional<TraceMistake> one = the_one(known, failures);
    if (one && one->is_certain) return {*one};
    std::vector<TraceMistake> two = the_two(known, failures);
    if (two.empty() && one) return {*one};
    return two;
}

}  // namespace rt
