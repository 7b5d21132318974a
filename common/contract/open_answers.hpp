// Answers of functions whose contract leaves them open, compared by what the contract determines.
#pragma once

#include "common/contract/call.hpp"

namespace rt::contract {

/// True if two answers to the call are of the same kind. A shadow ray is compared by its start, in
/// errors of the point, and by its end, relative to the light; a reflected ray by its start and its
/// direction; all right ones are of one kind. A light's point is compared by its distance from the
/// center and its angle there, but not by its turn around the axis. Other values are not compared:
/// true.
[[nodiscard]] bool same_kind(const Call& call, const Answer& got, const Answer& expected);

/// True if same_kind compares the function's answers.
[[nodiscard]] bool is_compared_by_kind(const Callee& callee);

}  // namespace rt::contract
