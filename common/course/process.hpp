// Other programs.
#pragma once

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt {

/// What another program said was wrong, in its own words, which may be several lines.
class ProgramError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A program and its arguments.
using Command = std::vector<std::string>;

/// Runs a program, found as a shell finds it, until it ends: its exit status, or 128 + the number
/// of the signal that ended it, which is told unless it was Ctrl-C. Throws InputError if the
/// program cannot be started.
[[nodiscard]] int run_process(const Command& command);

/// How a program ended whose words were kept.
struct Ending {
    int status = 0;            ///< as run_process has it
    std::string crash;         ///< the signal that ended it, "Segmentation fault"; or nothing
    bool out_of_time = false;  ///< it was ended by us
    std::string output;        ///< of both streams, the first 64 KiB
};

/// Runs a program that says nothing to anybody but us, for so long at most. Throws InputError if
/// it cannot be started. With `cancelled` it ends as soon as that is set, and what it has started
/// with it; Ctrl-C is then ours to hear, and not the program's. It is asked to end (SIGTERM), and a
/// fifth of a second later is ended; it ends with the thread that listens, too.
[[nodiscard]] Ending listen_to(const Command& command, std::chrono::milliseconds limit,
                               const std::atomic<bool>* cancelled = nullptr);

/// The exit status that waitpid and pclose hide in their answer; 128 + the number of a signal.
[[nodiscard]] int exit_status(int answer);

}  // namespace rt
