#include "common/system/terminal.hpp"

#include "common/system/input_error.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"

#include <cstdio>

// Standard C++ can neither detect a terminal nor measure its width.
#if __has_include(<sys/ioctl.h>)
#include <sys/ioctl.h>
#endif
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string_view>

namespace rt {

namespace {

bool wants_color() {
    if (std::getenv("NO_COLOR") != nullptr) return false;
    const char* forced = std::getenv("CLICOLOR_FORCE");
    if (forced != nullptr && std::string_view(forced) != "0") return true;
    return output_on_terminal() && terminal_is_capable();
}

}  // namespace

void finish_output() {
    std::cout.flush();
    const bool was_wrong = std::ferror(stdout) != 0;
    errno = 0;
    if (std::fflush(stdout) == 0 && !was_wrong) return;
    const std::string why = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
    throw InputError({}, "the standard output cannot be written" + why);
}

void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
}

void print_line(const std::string& line) {
    std::puts(line.c_str());
}

void print_error(const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
}

bool errors_on_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

bool output_on_terminal() {
    return isatty(STDOUT_FILENO) == 1;
}

bool terminal_is_capable() {
    const char* kind = std::getenv("TERM");
    return kind == nullptr || std::string_view(kind) != "dumb";
}

int terminal_columns() {
#ifdef TIOCGWINSZ
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        winsize size{};
        if (ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    }
#endif
    const char* columns = std::getenv("COLUMNS");
    const int said = columns == nullptr ? 0 : std::atoi(columns);
    return said > 0 ? said : 80;
}

int terminal_rows() {
#ifdef TIOCGWINSZ
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0) return size.ws_row;
#endif
    return 24;
}

std::string styled(const std::string& text, Style paint) {
    static const bool in_color = wants_color();
    if (!in_color) return text;
    const char* code = "2";
    if (paint == Style::good) code = "32";
    if (paint == Style::bad) code = "31";
    if (paint == Style::bold) code = "1";
    return std::string("\033[") + code + "m" + text + "\033[0m";
}

std::string time_left(double seconds, int done, int total) {
    constexpr double least_seconds = 5;
    constexpr int least_part = 20;
    if (seconds < least_seconds || done * least_part < total) return "";
    return formatted(", %.0f s left", seconds * (total - done) / done);
}

Progress::Progress(bool shown, int total) : total_(total) {
    if (shown) status_.emplace("");
}

void Progress::advance() {
    if (!status_) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    const Clock::time_point now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    status_->show(formatted("%4d %%", 100 * done_ / total_) +
                  tr_text(time_left(seconds, done_, total_)));
}

}  // namespace rt

namespace rt {

StatusLine::StatusLine(const std::string& text)
    : in_place_(errors_on_terminal() && terminal_is_capable()) {
    show(text);
}

StatusLine::~StatusLine() {
    if (in_place_) std::fputs("\r\033[K", stderr);
}

void StatusLine::show(const std::string& text) {
    text_ = text;
    if (in_place_) {
        const auto most = static_cast<std::size_t>(terminal_columns() - 1);
        std::fprintf(stderr, "\r%s\033[K", text.substr(0, most).c_str());
    } else if (const Clock::time_point now = Clock::now(); now >= due_) {
        std::fprintf(stderr, "%s\n", text.c_str());
        due_ = now + std::chrono::seconds(15);
    }
    std::fflush(stderr);
}

}  // namespace rt
