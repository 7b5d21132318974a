#include "common/course/build/status_line.hpp"

#include "common/system/terminal.hpp"

#include <cstdio>

namespace rt {

StatusLine::StatusLine(const std::string& text) : shown_(errors_on_terminal()) {
    show(text);
}

StatusLine::~StatusLine() {
    if (shown_) std::fputs("\r\033[K", stderr);
}

void StatusLine::show(const std::string& text) const {
    if (!shown_) return;
    const auto most = static_cast<std::size_t>(terminal_columns() - 1);
    std::fprintf(stderr, "\r%s\033[K", text.substr(0, most).c_str());
    std::fflush(stderr);
}

}  // namespace rt
