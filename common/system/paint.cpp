#include "common/system/paint.hpp"

#include <unistd.h>

#include <cstdlib>

namespace rt {

std::string styled(const std::string& text, Style paint) {
    static const bool in_color = isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
    if (!in_color) return text;
    const char* code = "2";
    if (paint == Style::good) code = "32";
    if (paint == Style::bad) code = "31";
    if (paint == Style::bold) code = "1";
    return std::string("\033[") + code + "m" + text + "\033[0m";
}

}  // namespace rt
