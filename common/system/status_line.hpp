// A line about the work in progress, while nothing else is printed.
#pragma once

#include <chrono>
#include <string>

namespace rt {

/// A line on the standard error stream. On a terminal it is rewritten in place, and erased at the
/// end. Elsewhere, as in a pipe, on a "dumb" terminal, or in the log of a server, the line at the
/// time is printed after 5 seconds and then every 15 seconds. The script `course` does the same
/// before this is compiled.
class StatusLine {
public:
    explicit StatusLine(const std::string& text);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// Replaces the text.
    void show(const std::string& text);

    /// Shows the text again: call it at least every few seconds, also when nothing is new.
    void show_again() { show(text_); }

private:
    using Clock = std::chrono::steady_clock;

    bool in_place_;
    std::string text_;
    Clock::time_point due_ = Clock::now() + std::chrono::seconds(5);  ///< the next, if not in place
};

}  // namespace rt
