// The calls that a suite has reported as failing.
#pragma once

#include "common/contract/call.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt::contract {

/// The call of the stage that a suite has printed, without an interval that has no end; nothing if
/// it is none.
[[nodiscard]] std::optional<Call> call_of_suite(int stage, std::string text);

/// The calls of the stage's functions with which failures begin in the output of
/// tests/kit/report.cpp, in its order. Other questions, of several calls say, are left out.
[[nodiscard]] std::vector<Call> failing_calls(int stage, const std::string& report);

}  // namespace rt::contract
