#include "common/system/terminal.hpp"

#include "common/system/input_error.hpp"

#include <unistd.h>  // isatty, which standard C++ does not have

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

namespace rt {

void finish_output() {
    std::cout.flush();
    const bool was_wrong = std::ferror(stdout) != 0;
    errno = 0;
    if (std::fflush(stdout) == 0 && !was_wrong) return;
    const std::string why = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
    throw InputError({}, "the standard output cannot be written" + why);
}

bool errors_on_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

int terminal_columns() {
    const char* columns = std::getenv("COLUMNS");
    const int said = columns == nullptr ? 0 : std::atoi(columns);
    return said > 0 ? said : 80;
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
    const double left = seconds * (total_ - done_) / done_;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%4d %%, %.0f s left", 100 * done_ / total_, left);
    status_->show(text.data());
}

}  // namespace rt
