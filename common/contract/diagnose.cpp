// diagnose PROBES WORKER REFERENCE REPORT [SLICE.svg]
//
// Diagnoses the functions of WORKER, whose suite has written REPORT: prints the known mistakes that
// they show, or the smallest call with an answer that differs from the reference's. Exit status 0
// if nothing is found, 1 if something is, 2 if the worker could not be queried.
#include "common/contract/files.hpp"
#include "common/contract/paste.hpp"
#include "common/contract/probes.hpp"
#include "common/contract/slice.hpp"
#include "common/contract/smallest.hpp"

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

/// A function with constant answers is not written yet; a mistake with a sentence of its own may be
/// constant too. Returns true if all functions of the stage are constant: then nothing is written.
bool tell_what_never_changes(const Probes& probes, const std::vector<Answer>& answers) {
    bool all_do = true;
    for (const Callee& callee : callees()) {
        std::set<std::string> right;
        std::set<std::string> got;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            if (probes.probes[i].call.callee != &callee) continue;
            if (!answers[i].value) return false;
            right.insert(code(probes.probes[i].right));
            got.insert(code(answers[i]));
        }
        if (right.size() > 1 && got.size() == 1)
            std::cout << "always: " << callee.name << " answers " << *got.begin()
                      << ", for all arguments\n";
        else if (right.size() > 1)
            all_do = false;
    }
    return all_do;
}

int diagnose(const std::vector<std::string>& words) {
    if (words.size() < 4)
        throw std::runtime_error("diagnose PROBES WORKER REFERENCE REPORT [SLICE.svg]");
    const Probes probes = read_probes(content_of(words[0]));
    constexpr int crashes = 200;  // the search for the smallest call that crashes needs some
    Asked student(words[1], crashes);
    std::vector<Call> calls;
    for (const Probe& probe : probes.probes) calls.push_back(probe.call);
    const std::vector<Answer> answers = student(calls);
    const bool nothing_is_written = tell_what_never_changes(probes, answers);
    const std::vector<Mistake> mistakes =
        nothing_is_written ? std::vector<Mistake>{}
                           : recognized(probes, answers, read_case_results(content_of(words[3])));
    for (const Mistake& mistake : mistakes)
        std::cout << (mistake.is_earlier_part() ? "" : "mistake: " + mistake.name + ": ")
                  << mistake.sentence << '\n';
    if (!mistakes.empty()) return 1;

    Asked reference(words[2]);
    const auto difference = smallest_difference(probes, answers, student, reference);
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
