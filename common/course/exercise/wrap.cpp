#include "common/course/exercise/wrap.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

namespace rt {

namespace {

constexpr int narrowest = 40;
constexpr std::size_t deeper = 4;

bool begins_character(char byte) {  // in UTF-8
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

}  // namespace

std::string wrapped(const std::string& line, int columns) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size()) + deeper;
    std::string text;
    std::string part;        // since the last break or possible break
    std::size_t column = 0;  // of its start
    std::size_t width = 0;   // of the part
    bool in_quotes = false;
    const auto place = [&] {
        if (column > indent && column + width > std::size_t(columns)) {
            text.resize(text.find_last_not_of(' ') + 1);
            text += "\n" + std::string(indent, ' ');
            column = indent;
        }
        text += part;
        column += width;
        part.clear();
        width = 0;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        part += line[i];
        width += begins_character(line[i]) ? 1 : 0;
        if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) in_quotes = !in_quotes;
        if (!in_quotes && line[i] == ' ' && i > 0 && line[i - 1] == ',') place();
    }
    place();
    return text;
}

std::string wrapped(const std::string& line) {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return line;
    return wrapped(line, std::max(int(size.ws_col), narrowest));
}

}  // namespace rt
