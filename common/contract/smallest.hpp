// The smallest call on which two workers answer differently.
#pragma once

#include "common/contract/call.hpp"
#include "common/contract/probes.hpp"

#include <optional>
#include <vector>

namespace rt::contract {

/// The length of the text of a call's numbers: a plainer call is shorter.
[[nodiscard]] double length_of(const Call& call);

/// The call with less in it, or with one of its numbers plainer: large steps first. Some are not
/// shorter, or break a condition of the contract.
[[nodiscard]] std::vector<Call> plainer_calls(const Call& call);

/// The call without the sign of a zero.
[[nodiscard]] Call without_signed_zeros(Call call);

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

// The conditions of a contract that a plainer call must keep.

/// Unit lengths stay unit, positive numbers stay positive, and shares stay between 0 and 1, as in
/// the call from which the search starts.
class Conditions {
public:
    explicit Conditions(Call call) : start_(std::move(call)) {}

    [[nodiscard]] bool hold(Call call) const;

private:
    Call start_;
};

/// True if a call's arguments are independent. The point of a normal is on the shape, and the point
/// of a weight is in the triangle's plane: those must change together.
[[nodiscard]] bool is_free(const Callee& callee);

}  // namespace rt::contract
