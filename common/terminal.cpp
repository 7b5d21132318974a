#include "common/terminal.hpp"

#include <cstdio>
#include <cstdlib>

// The one question that standard C++ cannot ask.
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace rt {

bool errors_on_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) == 1;
#endif
}

int terminal_columns() {
    const char* columns = std::getenv("COLUMNS");
    const int said = columns == nullptr ? 0 : std::atoi(columns);
    return said > 0 ? said : 80;
}

Progress::Progress(bool shown, int total) : shown_(shown), total_(total) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::advance() {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    const Clock::time_point now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = seconds * (total_ - done_) / done_;
    std::fprintf(stderr, "\r%4d %%, %.0f s left\033[K", 100 * done_ / total_, left);
    std::fflush(stderr);
}

}  // namespace rt
