#include "common/scene_file/lexer.hpp"

#include <algorithm>

namespace rt {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The offset of the line's comment; the line's size if it has none.
std::size_t comment_start(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '#') return i;
        const bool word_starts = i == 0 || blanks.find(line[i - 1]) != std::string_view::npos;
        if (word_starts && line.substr(i).starts_with("//")) return i;
    }
    return line.size();
}

/// The words between two offsets of the line, whose first byte is at `column`.
std::vector<Token> words(std::string_view line, std::size_t begin, std::size_t end, int column) {
    std::vector<Token> found;
    while (true) {
        begin = line.find_first_not_of(blanks, begin);
        if (begin >= end) return found;
        const std::size_t stop = std::min(line.find_first_of(blanks, begin), end);
        found.push_back({line.substr(begin, stop - begin), column + static_cast<int>(begin)});
        begin = stop;
    }
}

/// The offset of the words of a "# rt: …" comment; the line's size for any other comment.
std::size_t directive_start(std::string_view line, std::size_t comment) {
    if (comment == line.size() || line[comment] != '#') return line.size();
    const std::size_t word = std::min(line.find_first_not_of(blanks, comment + 1), line.size());
    const std::string_view mark = "rt:";
    return line.substr(word).starts_with(mark) ? word + mark.size() : line.size();
}

}  // namespace

char line_end(std::string_view text) {
    return text.find('\n') == std::string_view::npos ? '\r' : '\n';
}

Lines::Lines(std::string_view text) : rest_(text), end_(line_end(text)) {
    if (!rest_.starts_with(byte_order_mark)) return;
    rest_.remove_prefix(byte_order_mark.size());
    skipped_ = static_cast<int>(byte_order_mark.size());
}

std::optional<Line> Lines::next() {
    if (rest_.empty()) return std::nullopt;
    const std::string_view line = rest_.substr(0, rest_.find(end_));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    const int column = 1 + skipped_;
    skipped_ = 0;
    const std::size_t comment = comment_start(line);
    return Line{.number = ++number_,
                .tokens = words(line, 0, comment, column),
                .comment = {line.substr(comment), column + static_cast<int>(comment)},
                .directives = words(line, directive_start(line, comment), line.size(), column)};
}

void take_from_comment(Line& line) {
    const auto [text, column] = line.comment;
    const std::size_t end = text.empty() ? 0 : 1 + comment_start(text.substr(1));
    for (const Token token : words(text, 0, end, column)) line.tokens.push_back(token);
    line.comment = {text.substr(end), column + static_cast<int>(end)};
}

Token joined(Token first, Token last) {
    const char* end = last.text.data() + last.text.size();
    return {{first.text.data(), static_cast<std::size_t>(end - first.text.data())}, first.column};
}

}  // namespace rt
