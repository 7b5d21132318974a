// The smallest call on which two workers answer differently.
#pragma once

#include "common/contract/probes.hpp"

#include <optional>

namespace rt::contract {

/// A call that the contract leaves no doubt about, and two answers to it.
struct Difference {
    Call call;
    Answer got;
    Answer expected;
};

/// The plainest call on which the student's answer differs from the reference's, with its numbers
/// rounded as far as possible. The search begins at the suite's `failing` calls; if none of them
/// differs, at the probes, and at calls like them. Nothing if there is none. `answers` are the
/// student's answers to the probes, in their order.
[[nodiscard]] std::optional<Difference> smallest_difference(const Probes& probes,
                                                            const std::vector<Answer>& answers,
                                                            Asked& student, Asked& reference,
                                                            const std::vector<Call>& failing = {});

}  // namespace rt::contract
