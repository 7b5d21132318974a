// The file tests/mistakes/<stage>/probes.txt: calls that distinguish the known mistakes of a stage
// from the reference, with the answers of each. It identifies a mistake without its source.
#pragma once

#include "common/contract/call.hpp"

#include <string>
#include <vector>

namespace rt::contract {

struct Mistake {
    std::string name;
    std::string sentence;
};

struct Probe {
    Call call;
    Answer right;
    /// One answer per mistake, in the order of Probes::mistakes.
    std::vector<Answer> mistaken;
};

struct Probes {
    int stage = 0;
    std::vector<Mistake> mistakes;
    /// Functions whose contract leaves the answer open: other right answers differ.
    std::vector<std::string> open;
    std::vector<Probe> probes;
};

/// Throws Malformed.
[[nodiscard]] Probes read_probes(const std::string& text);
[[nodiscard]] std::string text_of(const Probes& probes);

/// True if the contract determines the call's answer.
[[nodiscard]] bool is_open(const Probes& probes, const Callee& callee);

/// True if a probe distinguishes the mistake from the reference. There is no such probe if they
/// differ by less than right answers do.
[[nodiscard]] bool is_recognisable(const Probes& probes, const std::string& mistake);

/// The mistakes that the answers to all probes, in their order, show. A mistake is recognized if
/// the answers equal its own for every probe of the functions in which it differs from the
/// reference, and are not the reference's.
[[nodiscard]] std::vector<Mistake> recognised(const Probes& probes,
                                              const std::vector<Answer>& answers);

/// A mistake is computed in many ways, and then rounded otherwise.
inline constexpr double mistake_tolerance = 1e-9;

/// The suites', of kit/verdict.hpp.
inline constexpr double right_tolerance = 4096 * std::numeric_limits<double>::epsilon();

}  // namespace rt::contract
