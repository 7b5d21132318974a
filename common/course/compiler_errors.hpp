// What a compiler says, put so that a student reads what he wrote wrong, and nothing else.
#pragma once

#include <string>

namespace rt {

/// The first error that has to do with a file of steps/…/student/: its place from the project's
/// folder on, what is wrong, and the lines that show it. All of the output if there is none.
[[nodiscard]] std::string first_error(const std::string& output);

/// The first warning of such a file, in the same form; nothing if there is none.
[[nodiscard]] std::string first_warning(const std::string& output);

}  // namespace rt
