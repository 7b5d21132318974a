// Messages about the student's other stages: which are used, and which are not right.
#pragma once

#include <string>

namespace rt {

/// If other stages are started that this one builds on, the line that it is judged with references
/// in place of them.
[[nodiscard]] std::string references_used(int stage);

/// Warns, on the standard error stream, of each of these stages that is used and did not pass its
/// last check as it is now. `references` ("3;5") are not used.
void warn_of_earlier(int stage, const std::string& references);

}  // namespace rt
