// Output to the terminal, and its properties.
#pragma once

#include <chrono>
#include <mutex>

namespace rt {

/// Flushes the standard output. Throws InputError if not all of it could be written: the disk may
/// be full, or a pipe closed.
void finish_output();

/// Returns whether the standard error stream is a terminal.
[[nodiscard]] bool errors_on_terminal();

/// The width of the terminal in characters, as the terminal reports it.
[[nodiscard]] int terminal_columns();

/// A progress line "  45 %, 3 s left" on the standard error stream, rewritten in place and erased
/// at the end. Any thread may report progress.
class Progress {
public:
    /// Prints nothing unless `shown`.
    Progress(bool shown, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Counts one more of the total as done.
    void advance();

private:
    using Clock = std::chrono::steady_clock;

    bool shown_;
    int total_;
    int done_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    std::mutex mutex_;
};

}  // namespace rt
