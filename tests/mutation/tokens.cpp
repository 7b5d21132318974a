#include "tests/mutation/tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace mutation {

namespace {

bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool in_number(char c) {
    return in_word(c) || c == '.' || c == '\'';
}

bool is_space(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The length of a non-code prefix: a space, a comment, a preprocessor line.
std::size_t skipped(std::string_view rest) {
    if (is_space(rest[0])) return 1;
    if (rest[0] == '#' || rest.starts_with("//")) return std::min(rest.find('\n'), rest.size());
    if (rest.starts_with("/*")) return rest.find("*/") + 2;
    return 0;
}

std::size_t quoted(std::string_view rest) {
    std::size_t end = 1;
    while (rest[end] != rest[0]) end += rest[end] == '\\' ? 2 : 1;
    return end + 1;
}

std::size_t length_of_token(std::string_view rest) {
    if (rest[0] == '"' || rest[0] == '\'') return quoted(rest);
    if (in_word(rest[0])) {
        const auto part = std::isdigit(static_cast<unsigned char>(rest[0])) ? in_number : in_word;
        return std::size_t(std::find_if_not(rest.begin(), rest.end(), part) - rest.begin());
    }
    constexpr std::array<std::string_view, 14> two = {"::", "->", "<=", ">=", "==", "!=", "&&",
                                                      "||", "++", "--", "+=", "-=", "*=", "/="};
    const auto starts = [rest](std::string_view symbol) { return rest.starts_with(symbol); };
    return std::any_of(two.begin(), two.end(), starts) ? 2 : 1;
}

void pair_brackets(std::vector<Token>& tokens) {
    std::vector<int> open;
    for (int i = 0; i < int(tokens.size()); ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "(" || text == "[" || text == "{") open.push_back(i);
        if (text != ")" && text != "]" && text != "}") continue;
        tokens[i].partner = open.back();
        tokens[open.back()].partner = i;
        open.pop_back();
    }
}

}  // namespace

std::vector<Token> tokens_of(std::string_view source) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < source.size();) {
        const std::string_view rest = source.substr(at);
        if (const std::size_t none = skipped(rest); none > 0) {
            at += none;
            continue;
        }
        const std::size_t length = length_of_token(rest);
        const bool apart = is_space(source[at - 1]) && is_space(source[at + length]);
        tokens.push_back({.text = rest.substr(0, length), .binary = apart});
        at += length;
    }
    pair_brackets(tokens);
    return tokens;
}

bool is_name(const Token& token) {
    return in_word(token.text[0]) && !is_number(token);
}

bool is_number(const Token& token) {
    return std::isdigit(static_cast<unsigned char>(token.text[0])) != 0;
}

}  // namespace mutation
