#include "common/system/status_line.hpp"

#include "common/system/terminal.hpp"

#include <cstdio>

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
