// The smallest call on which two answer differently.
#pragma once

#include "tests/contract/probes.hpp"

#include <optional>

namespace rt::contract {

/// A call that the contract leaves no doubt about, and two answers to it.
struct Difference {
    Call call;
    Answer came;
    Answer expected;
};

/// Among the probes and calls like them, the plainest on which the student's answer is not the
/// reference's; its numbers made as round as they can be while that stays so. Nothing, if there is
/// none. The probes' answers are the student's, in their order.
[[nodiscard]] std::optional<Difference> smallest_difference(const Probes& probes,
                                                            const std::vector<Answer>& answers,
                                                            Asked& student, Asked& reference);

}  // namespace rt::contract
