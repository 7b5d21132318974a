#include "common/course/exercise/telling_case.hpp"

#include "common/course/exercise/hints.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace rt {

namespace {

using Known = std::map<std::string, KnownFailure>;

/// The digests of the questions, which begin those of the failures (tests/kit/report.hpp).
std::set<std::string> questions_in(const std::string& failures) {
    constexpr std::size_t digits = 8;
    std::set<std::string> questions;
    for (const std::string& word : words_of(failures)) questions.insert(word.substr(0, digits));
    return questions;
}

/// "case intersect normal: name", and for each mistake "fails ..x.. mistake", in their order.
void read_probes(const fs::path& file, Known& known,
                 std::map<std::string, std::set<std::string>>& calls) {
    std::vector<std::string> cases;
    for (const std::string& line : lines_in(file)) {
        if (const auto rest = after("case ", line)) {
            const std::size_t colon = rest->find(": ");
            if (colon == std::string::npos) continue;
            cases.push_back(rest->substr(colon + 2));
            const std::vector<std::string> called = words_of(rest->substr(0, colon));
            calls[cases.back()] = {called.begin(), called.end()};
        }
        const auto marks = after("fails ", line);
        if (!marks) continue;
        KnownFailure& failure = known[marks->substr(marks->find(' ') + 1)];
        for (std::size_t i = 0; i < cases.size() && i < marks->size(); ++i)
            if ((*marks)[i] == 'x') failure.failures.insert(cases[i]);
    }
}

/// "mistake name: sentence", then the digests of its failures.
void read_trace(const fs::path& file, Known& known) {
    std::string mistake;
    for (const std::string& line : lines_in(file)) {
        if (const auto rest = after("mistake ", line))
            mistake = rest->substr(0, rest->find(':'));
        else if (!mistake.empty())
            known[mistake].failures.merge(questions_in(line));
    }
}

/// "mistake name in file", then "caught by: case", in a suite's catalogue.
void read_authors_cases(const fs::path& mistakes, const std::string& suite, Known& known) {
    const fs::path whole = mistakes / (suite + ".txt");
    std::string mistake;
    for (const std::string& line :
         lines_in(fs::exists(whole) ? whole : in_handout(mistakes) / whole.filename())) {
        if (const auto rest = after("mistake ", line)) mistake = rest->substr(0, rest->find(' '));
        const auto caught_by = after("caught by: ", line);
        const auto found = known.find(mistake);
        if (caught_by && found != known.end()) found->second.caught_by = *caught_by;
    }
}

std::set<std::string> calls_of(const CaseResult& result, const KnownCases& known) {
    const auto found = known.calls.find(result.name);
    return found == known.calls.end() ? std::set<std::string>() : found->second;
}

bool is_picture(const std::string& name) {
    return name.starts_with("the picture");
}

/// The suite of `trace` is linked to right functions.
bool is_trace(const std::string& part) {
    return part == "trace" || part == "render";
}

/// The failures by which a case is compared with known mistakes: its name, or for `trace` the
/// digests of its questions. A case that passes, and a picture, has none.
std::set<std::string> failures_of(const CaseResult& result) {
    if (result.passed || is_picture(result.name)) return {};
    if (is_trace(result.part)) return questions_in(result.failures);
    return {result.name};
}

bool share_any(const std::set<std::string>& a, const std::set<std::string>& b) {
    return std::ranges::any_of(a, [&](const auto& each) { return b.contains(each); });
}

/// What two sets of failures share, 0 to 1: all or nothing counts most.
double likeness(const std::set<std::string>& a, const std::set<std::string>& b) {
    const auto shared =
        double(std::ranges::count_if(a, [&](const auto& each) { return b.contains(each); }));
    return std::pow(shared / (double(a.size()) + double(b.size()) - shared), 4);
}

}  // namespace

fs::path in_handout(const fs::path& mistakes) {
    return mistakes / "caught_by";
}

std::string authors_cases(const std::string& catalogue) {
    std::string lines;
    for (const std::string& line : lines_of(catalogue))
        if (line.starts_with("mistake ") || line.starts_with("caught by: ")) lines += line + "\n";
    return lines;
}

KnownCases known_cases(const fs::path& mistakes, const std::string& stage) {
    KnownCases cases;
    Known of_functions;
    read_probes(mistakes / stage / "probes.txt", of_functions, cases.calls);
    read_authors_cases(mistakes, stage, of_functions);
    Known of_trace;
    read_trace(mistakes / stage / "trace.txt", of_trace);
    read_authors_cases(mistakes, stage + "_trace", of_trace);
    for (const Known& known : {of_functions, of_trace})
        for (const auto& [name, failure] : known)
            cases.mistakes.push_back({name, failure.failures, failure.caught_by});
    for (KnownFailure& each : cases.mistakes)
        std::erase_if(each.failures, [](const std::string& name) { return is_picture(name); });
    std::erase_if(cases.mistakes, [](const KnownFailure& each) { return each.failures.empty(); });
    return cases;
}

std::string part_to_mend(const std::vector<CaseResult>& cases, const KnownCases& known) {
    std::set<std::string> wrong;
    for (const CaseResult& each : cases)
        if (const auto called = calls_of(each, known); !each.passed && called.size() == 1)
            wrong.insert(*called.begin());
    std::string first;
    for (const CaseResult& each : cases) {
        if (each.passed) continue;
        if (first.empty()) first = each.part;
        const auto called = calls_of(each, known);
        const auto is_wrong = [&](const std::string& name) { return wrong.contains(name); };
        const auto is_own = [&](const std::string& name) {
            return is_wrong(name) && names(each.part, name);
        };
        if (std::ranges::any_of(called, is_own) || std::ranges::none_of(called, is_wrong))
            return each.part;
    }
    return first;
}

std::size_t most_telling(const std::vector<CaseResult>& cases, const std::string& part,
                         const std::vector<std::string>& recognized, const KnownCases& known) {
    std::set<std::string> failing;
    std::map<std::string, std::set<std::string>> failures;  // by case
    for (const CaseResult& each : cases)
        if (is_trace(each.part) == is_trace(part)) {
            failures[each.name] = failures_of(each);
            failing.insert(failures[each.name].begin(), failures[each.name].end());
        }
    std::map<std::string, double> votes;
    std::map<std::string, int> mistakes;
    std::set<std::string> of_recognized;
    for (const KnownFailure& each : known.mistakes) {
        votes[each.caught_by] += likeness(failing, each.failures);
        for (const auto& [name, of_case] : failures)
            if (share_any(of_case, each.failures)) ++mistakes[name];
        if (std::ranges::find(recognized, each.mistake) != recognized.end())
            of_recognized.insert(each.caught_by);
    }
    // The least is the most telling.
    const auto order = [&](const CaseResult& each) {
        return std::tuple(!of_recognized.contains(each.name), is_picture(each.name),
                          each.is_random(), -votes[each.name], mistakes[each.name]);
    };
    std::size_t best = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (!cases[i].passed && cases[i].part == part &&
            (best == cases.size() || order(cases[i]) < order(cases[best])))
            best = i;
    return best;
}

std::size_t first_failing(const std::vector<CaseResult>& cases, const std::string& part) {
    const auto first = std::ranges::find_if(
        cases, [&](const CaseResult& each) { return !each.passed && each.part == part; });
    return std::size_t(first - cases.begin());
}

std::vector<std::string> parts_that_use(const std::string& part,
                                        const std::vector<CaseResult>& cases,
                                        const KnownCases& known) {
    std::map<std::string, std::string> part_of;
    for (const CaseResult& each : cases) part_of[each.name] = each.part;
    std::set<std::string> using_it;
    for (const KnownFailure& each : known.mistakes) {
        std::set<std::string> parts;
        for (const std::string& name : each.failures) parts.insert(part_of[name]);
        if (parts.contains(part)) using_it.merge(parts);
    }
    for (const CaseResult& each : cases)
        for (const std::string& called : calls_of(each, known))
            if (names(part, called)) using_it.insert(each.part);
    std::vector<std::string> using_parts;
    for (const CaseResult& each : cases)
        if (!each.passed && each.part != part && using_it.contains(each.part) &&
            std::ranges::find(using_parts, each.part) == using_parts.end())
            using_parts.push_back(each.part);
    return using_parts;
}

}  // namespace rt
