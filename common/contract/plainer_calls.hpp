// Plainer calls than one that fails.
#pragma once

#include "common/contract/call.hpp"

#include <vector>

namespace rt::contract {

/// The length of the text of a call's numbers: a plainer call is shorter.
[[nodiscard]] double length_of(const Call& call);

/// The call with less in it, or with one of its numbers plainer: large steps first. Some are not
/// shorter, or break a condition of the contract.
[[nodiscard]] std::vector<Call> plainer_calls(const Call& call);

/// The call without the sign of a zero.
[[nodiscard]] Call without_signed_zeros(Call call);

}  // namespace rt::contract
