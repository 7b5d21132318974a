#include "common/system/wrap.hpp"

#include "common/system/terminal.hpp"
#include "common/system/text.hpp"

#include <algorithm>

namespace rt {

namespace {

constexpr int narrowest = 40;
constexpr int widest = 120;
constexpr std::size_t deeper = 4;

bool begins_character(char byte) {  // in UTF-8
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// Whether the braces that open there contain numbers only: "{0, 0, 1}".
bool opens_numbers(const std::string& line, std::size_t brace) {
    const std::size_t end = line.find_first_of("{}=", brace + 1);
    return line[brace] == '{' && end != std::string::npos && line[end] == '}';
}

}  // namespace

std::size_t columns_of(const std::string& text) {
    return std::size_t(std::ranges::count_if(text, begins_character));
}

std::string shortened(const std::string& line, int columns) {
    int width = 0;
    std::size_t end = line.size();  // of what leaves a column free
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!begins_character(line[i])) continue;
        if (++width == columns) end = i;
        if (width > columns) return line.substr(0, end) + "…";
    }
    return line;
}

std::string wrapped(const std::string& line, int columns) {
    return wrapped(line, columns, std::min(line.find_first_not_of(' '), line.size()) + deeper);
}

std::string wrapped(const std::string& line, int columns, std::size_t indent) {
    std::string text;
    std::string part;        // since the last break or possible break
    std::size_t column = 0;  // of its start
    std::size_t width = 0;   // of the part
    bool in_quotes = false;
    bool in_numbers = false;
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
        if (line[i] == '{') in_numbers = opens_numbers(line, i);
        if (line[i] == '}') in_numbers = false;
        const bool at_sign = (i > 0 && line[i - 1] == '=') || line[i + 1] == '=';
        if (!in_quotes && !in_numbers && !at_sign && line[i] == ' ') place();
    }
    place();
    return text;
}

std::string wrapped(const std::string& line) {
    return output_on_terminal() ? wrapped(line, std::max(terminal_columns(), narrowest)) : line;
}

std::string wrapped_prose(const std::string& line) {
    return output_on_terminal() ? wrapped(line, std::max(terminal_columns(), narrowest), 0) : line;
}

std::string wrapped_code(const std::string& line) {
    return wrapped(
        line, output_on_terminal() ? std::clamp(terminal_columns(), narrowest, widest) : widest);
}

std::string wrapped_diagnostic(const std::string& text, int columns) {
    std::string all;
    for (const std::string& line : lines_of(text))
        all += (line.starts_with(' ') ? shortened(line, columns) : wrapped(line, columns)) + '\n';
    return all;
}

std::string wrapped_diagnostic(const std::string& text) {
    return output_on_terminal() ? wrapped_diagnostic(text, std::max(terminal_columns(), narrowest))
                                : text;
}

std::string wrapped_page(const std::string& text, std::size_t column) {
    const int columns = std::max(terminal_columns(), narrowest);
    std::string page;
    for (const std::string& line : lines_of(text))
        page += (line.starts_with(' ') ? wrapped(line, columns, column) : wrapped(line, columns)) +
                '\n';
    return page;
}

}  // namespace rt
