// The file tests/mistakes/<stage>/probes.txt: calls that distinguish the known mistakes of a stage
// from the reference, with the answers of each, and the cases of the suite that each mistake fails.
// It identifies a mistake without its source.
#pragma once

#include "common/contract/call.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::contract {

/// A case of the stage's suite.
struct SuiteCase {
    std::string name;
    std::vector<const Callee*> calls;  ///< the stage's functions that it calls
};

struct Mistake {
    std::string name;
    std::string sentence;
    std::vector<bool> fails = {};  ///< in the order of Probes::cases

    /// True for the right answer of an earlier part of the stage: there is nothing wrong about it,
    /// the next part is to be written.
    [[nodiscard]] bool is_earlier_part() const { return sentence.starts_with("Not finished: "); }
};

struct Probe {
    Call call;
    Answer right;
    /// One answer per mistake, in the order of Probes::mistakes.
    std::vector<Answer> mistaken;
};

/// The cases that a suite has run, by name: true if the case has passed.
using CaseResults = std::map<std::string, bool>;

/// Parses the output of tests/kit/report.cpp. A case without an end, after a crash, has failed.
[[nodiscard]] CaseResults read_case_results(const std::string& report);

struct Probes {
    int stage = 0;
    std::vector<SuiteCase> cases;
    std::vector<Mistake> mistakes;
    /// Functions whose contract leaves the answer open: other right answers differ.
    std::vector<std::string> open;
    std::vector<Probe> probes;
};

/// Throws Malformed.
[[nodiscard]] Probes read_probes(const std::string& text);
[[nodiscard]] std::string text_of(const Probes& probes);

/// True if the contract leaves the function's answer open.
[[nodiscard]] bool is_open(const Probes& probes, const Callee& callee);

/// True if a probe distinguishes the mistake from the reference. There is no such probe if they
/// differ by less than right answers do.
[[nodiscard]] bool is_recognisable(const Probes& probes, const std::string& mistake);

/// A mistake is computed in many ways, and then rounded otherwise.
inline constexpr double mistake_tolerance = 1e-9;

/// The suites', of kit/verdict.hpp.
inline constexpr double right_tolerance = 4096 * std::numeric_limits<double>::epsilon();

// Reading of files.

/// Throws std::runtime_error, if it cannot be read.
[[nodiscard]] std::string content_of(const std::string& file);

// Answers of functions whose contract leaves them open, compared by what the contract determines.

/// True if two answers to the call are of the same kind. A shadow ray is compared by its start, in
/// errors of the point, and by its end, relative to the light; a reflected ray by its start and its
/// direction; all right ones are of one kind. A light's point is compared by its distance from the
/// center and its angle there, but not by its turn around the axis. Other values are not compared:
/// true.
[[nodiscard]] bool same_kind(const Call& call, const Answer& got, const Answer& expected);

/// True if same_kind compares the function's answers.
[[nodiscard]] bool is_compared_by_kind(const Callee& callee);

}  // namespace rt::contract
