// Output to the terminal, and its properties.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace rt {

/// Flushes the standard output. Throws InputError if not all of it could be written: the disk may
/// be full, or a pipe closed.
void finish_output();

/// Prints a text on the standard output.
void print(const std::string& text);

/// Prints a line, on the standard output or on the standard error stream.
void print_line(const std::string& line);
void print_error(const std::string& line);

/// Returns whether the standard error stream is a terminal.
[[nodiscard]] bool errors_on_terminal();

[[nodiscard]] bool output_on_terminal();

/// Returns whether the terminal can do more than print lines: $TERM is not "dumb".
[[nodiscard]] bool terminal_is_capable();

/// The width in characters of the terminal of the standard output or else of the standard error
/// stream; without a terminal $COLUMNS, or 80 if it is not set.
[[nodiscard]] int terminal_columns();

/// The height in lines of the terminal of the standard output, or 24.
[[nodiscard]] int terminal_rows();

enum class Style { good, bad, bold, dim };

/// The text in color, if the standard output is a terminal that is not "dumb", or CLICOLOR_FORCE is
/// set to something but 0; never if NO_COLOR is set.
[[nodiscard]] std::string styled(const std::string& text, Style paint);

/// ", 3 s left" after this many seconds for `done` of `total` equal parts; empty while this is a
/// guess: in the first 5 seconds, and before a twentieth is done.
[[nodiscard]] std::string time_left(double seconds, int done, int total);

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
