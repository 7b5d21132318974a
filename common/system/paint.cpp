#include "common/system/paint.hpp"

#include "common/system/terminal.hpp"

#include <cstdlib>
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

std::string styled(const std::string& text, Style paint) {
    static const bool in_color = wants_color();
    if (!in_color) return text;
    const char* code = "2";
    if (paint == Style::good) code = "32";
    if (paint == Style::bad) code = "31";
    if (paint == Style::bold) code = "1";
    return std::string("\033[") + code + "m" + text + "\033[0m";
}

}  // namespace rt
