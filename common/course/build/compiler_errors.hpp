// Compiler output, reduced to the first error in the student's own files.
#pragma once

#include <string>

namespace rt {

/// The first error that concerns a file of steps/…/student/: its path relative to the project's
/// folder, the message, and the source lines that the compiler quotes. Returns the whole output if
/// there is no such error.
[[nodiscard]] std::string first_error(const std::string& output);

/// The first warning about such a file, in the same form; empty without a warning. A warning about
/// a header's function that was inlined there is one, at its call. A value that is not set, or
/// whose object is gone, is more than all others.
[[nodiscard]] std::string first_warning(const std::string& output);

}  // namespace rt
