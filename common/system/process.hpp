// Child processes.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The error output of another program, which may be several lines.
class ProgramError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A program and its arguments.
using Command = std::vector<std::string>;

/// True if a program of that name is on PATH.
[[nodiscard]] bool is_installed(const std::string& program);

/// Runs a program, found on PATH, until it ends. Returns its exit status, or 128 + the number of
/// the signal that ended it; such a signal is reported unless it was Ctrl-C. Throws InputError if
/// the program cannot be started.
[[nodiscard]] int run_process(const Command& command);

/// The output of a program that is captured; the other stream remains the caller's.
enum class Streams { output, both };

/// Runs a program until it ends, and passes on its output in pieces, with an empty piece at the
/// start and whenever nothing was printed for a second. Returns the same as run_process. Throws
/// InputError if the program cannot be started.
[[nodiscard]] int run_heard(const Command& command, Streams streams,
                            const std::function<void(std::string_view piece)>& hear);

/// The result of a program with captured output.
struct ProcessResult {
    int status = 0;            ///< the same as the result of run_process
    std::string crash;         ///< the name of the signal that ended it, "Segmentation fault"; or
                               ///< empty
    bool out_of_time = false;  ///< stopped after the time limit
    double processor_seconds = 0;  ///< of the program, and of the children that it waited for
    std::string output;            ///< both streams, at most the first most_output bytes
};

/// Runs a program with its output captured, and stops it after `limit` by the clock, without the
/// time in which the caller was stopped itself (Countdown). Throws InputError if it cannot be
/// started. With `cancelled`, the program and its children are stopped when `*cancelled` becomes
/// true, and Ctrl-C is handled by the caller instead of the program. To stop it, SIGTERM is sent,
/// and SIGKILL a fifth of a second later. The program is also stopped when the calling thread ends.
/// On Linux, processes that it leaves running are ended, too.
[[nodiscard]] ProcessResult run_captured(const Command& command, std::chrono::milliseconds limit,
                                         const std::atomic<bool>* cancelled = nullptr,
                                         std::size_t most_output = 64 * 1024);

/// The exit status in a result of waitpid; 128 + the number of a signal.
[[nodiscard]] int exit_status(int answer);

/// True for the exit status of a program that SIGINT (Ctrl-C), SIGTERM or SIGHUP ended: it did not
/// crash, somebody stopped it.
[[nodiscard]] bool is_stopped(int status);

}  // namespace rt
