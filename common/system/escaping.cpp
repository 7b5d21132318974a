#include "common/system/escaping.hpp"

namespace rt {

namespace {

constexpr std::size_t longest_quote = 40;

/// The two hexadecimal digits of a byte.
std::string hexadecimal(char byte) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto value = static_cast<unsigned char>(byte);
    return {digits[value / 16], digits[value % 16]};
}

}  // namespace

std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text.substr(0, longest_quote)) {
        if (' ' <= c && c <= '~')
            result += c;
        else
            result += "\\x" + hexadecimal(c);
    }
    return result + (text.size() > longest_quote ? "...\"" : "\"");
}

std::string percent_encoded(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') ||
                           ('0' <= c && c <= '9') ||
                           std::string_view("-._~").find(c) != std::string_view::npos;
        if (plain)
            result += c;
        else
            result += "%" + hexadecimal(c);
    }
    return result;
}

std::string shell_word(const std::string& word) {
    constexpr const char* plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text;
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return "'" + text + "'";
}

}  // namespace rt
