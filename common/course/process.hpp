// Other programs.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// Runs a program, found as a shell finds it, until it ends: its exit status, or 128 + the number
/// of the signal that ended it, which is told unless it was Ctrl-C. Throws InputError if the
/// program cannot be started.
[[nodiscard]] int run_process(const std::vector<std::string>& command);

/// The exit status that waitpid and pclose hide in their answer; 128 + the number of a signal.
[[nodiscard]] int exit_status(int answer);

}  // namespace rt
