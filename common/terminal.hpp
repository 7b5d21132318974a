// What is known of the terminal.
#pragma once

#include <chrono>
#include <mutex>

namespace rt {

/// Throws InputError unless all that was printed has been taken: a disk may be full, or nobody be
/// there.
void finish_output();

/// Whether somebody reads the standard error stream on a terminal.
[[nodiscard]] bool errors_on_terminal();

/// How many characters wide the terminal is said to be.
[[nodiscard]] int terminal_columns();

/// "  45 %, 3 s left" on the standard error stream, rewritten in place, gone at the end. Any
/// thread may report.
class Progress {
public:
    /// Silent unless `shown`.
    Progress(bool shown, int total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

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
