// diagnose PROBES WORKER REFERENCE REPORT [SLICE.svg [UNWRITTEN...]]
//
// Diagnoses the functions of WORKER, whose suite has written REPORT: prints the known mistakes that
// they show, or the smallest call with an answer that differs from the reference's. Exit status 0
// if nothing is found, 1 if something is, 2 if the worker could not be queried.
#include "common/contract/call.hpp"
#include "common/contract/difference_texts.hpp"
#include "common/contract/probes.hpp"
#include "common/contract/recognition.hpp"
#include "common/contract/smallest.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>

namespace rt::contract {

namespace {

void explain(const Difference& difference) {
    const auto& [call, got, expected] = difference;
    std::cout << "smallest: " << code(call) << "\n  got:      " << answer_text(call, got)
              << "\n  expected: " << answer_text(call, expected)
              << "\n  paste:    " << paste_line(call, *expected.value) << '\n';
}

/// A function with constant answers is not written yet, or one early return hides everything else:
/// the answers identify no mistake, even if those of a known one are the same.
void tell_what_never_changes(const Probes& probes, const std::vector<Answer>& answers) {
    for (const Callee& callee : callees()) {
        if (!is_constant(probes, answers, callee)) continue;
        const auto first = std::ranges::find(probes.probes, &callee,
                                             [](const Probe& probe) { return probe.call.callee; });
        const Answer& answer = answers[std::size_t(first - probes.probes.begin())];
        if (!answer.value) continue;  // the suite says how it ended
        std::cout << "always: " << callee.name << " returns " << code(answer)
                  << " for every call that was tried.\n";
        if (code(answer) == "std::nullopt")
            std::cout << "One of the conditions under which it does so is always true: look at "
                         "each, and at what it compares.\n";
    }
}

/// Leaves out the probes of functions with these names, and the cases that call them.
void leave_out(const std::set<std::string>& names, Probes& probes, CaseResults& results) {
    const auto is_out = [&](const Callee* callee) { return names.contains(callee->name); };
    std::erase_if(probes.probes, [&](const Probe& probe) { return is_out(probe.call.callee); });
    for (const SuiteCase& each : probes.cases)
        if (std::ranges::any_of(each.calls, is_out)) results.erase(each.name);
}

int diagnose(const std::vector<std::string>& words) {
    if (words.size() < 4)
        throw std::runtime_error(
            "diagnose PROBES WORKER REFERENCE REPORT [SLICE.svg [UNWRITTEN...]]");
    Probes probes = read_probes(content_of(words[0]));
    const std::string report = content_of(words[3]);
    CaseResults results = read_case_results(report);
    if (words.size() > 5) leave_out({words.begin() + 5, words.end()}, probes, results);
    constexpr int crashes = 200;  // the search for the smallest call that crashes needs some
    Asked student(words[1], crashes);
    std::vector<Call> calls;
    for (const Probe& probe : probes.probes) calls.push_back(probe.call);
    const std::vector<Answer> answers = student(calls);
    tell_what_never_changes(probes, answers);
    const std::vector<Recognized> mistakes = recognized(probes, answers, results);
    for (const auto& [mistake, is_certain] : mistakes)
        std::cout << (mistake.is_earlier_part() ? "" : "mistake: " + mistake.name + ": ")
                  << (is_certain ? "" : "Probably: ") << mistake.sentence << '\n';
    if (!mistakes.empty()) return 1;

    Asked reference(words[2]);
    const auto difference = smallest_difference(probes, answers, student, reference,
                                                failing_calls(probes.stage, report));
    if (!difference) return 0;
    explain(*difference);
    if (words.size() > 4 && can_be_drawn(difference->call))
        std::ofstream(words[4]) << slice(*difference, reference);
    return 1;
}

}  // namespace

}  // namespace rt::contract

int main(int argc, char** argv) {
    try {
        return rt::contract::diagnose({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
}
