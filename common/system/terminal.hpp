// Output to the terminal, and its properties.
#pragma once

#include "common/system/status_line.hpp"

#include <chrono>
#include <mutex>
#include <optional>

namespace rt {

/// Flushes the standard output. Throws InputError if not all of it could be written: the disk may
/// be full, or a pipe closed.
void finish_output();

/// Returns whether the standard error stream is a terminal.
[[nodiscard]] bool errors_on_terminal();

/// The width of the terminal in characters: $COLUMNS, or 80 if it is not set.
[[nodiscard]] int terminal_columns();

/// A status line "  45 %, 3 s left". Any thread may report progress.
class Progress {
public:
    /// Prints nothing unless `shown`.
    Progress(bool shown, int total);

    /// Counts one more of the total as done.
    void advance();

private:
    using Clock = std::chrono::steady_clock;

    std::optional<StatusLine> status_;
    int total_;
    int done_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    std::mutex mutex_;
};

}  // namespace rt
