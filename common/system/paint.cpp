#include "common/system/paint.hpp"

#include <unistd.h>

#include <cstdlib>

namespace rt {

std::string painted(const std::string& text, Paint paint) {
    static const bool in_color = isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
    if (!in_color) return text;
    const char* code = "2";
    if (paint == Paint::good) code = "32";
    if (paint == Paint::bad) code = "31";
    if (paint == Paint::bold) code = "1";
    return std::string("\033[") + code + "m" + text + "\033[0m";
}

}  // namespace rt
