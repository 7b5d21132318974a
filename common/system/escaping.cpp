#include "common/system/escaping.hpp"

#include <algorithm>
#include <array>

namespace rt {

namespace {

constexpr std::size_t longest_quote = 40;

std::string hexadecimal(char byte) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto value = static_cast<unsigned char>(byte);
    return {digits[value / 16], digits[value % 16]};
}

bool in(unsigned code, unsigned first, unsigned last) {
    return first <= code && code <= last;
}

bool is_readable(unsigned code) {
    const bool turns = in(code, 0x202a, 0x202e) || in(code, 0x2066, 0x2069);
    const bool controls = (code < 0x20 && code != '\n' && code != '\t') || in(code, 0x7f, 0x9f);
    const bool is_none = in(code, 0xd800, 0xdfff) || (code & 0xfffe) == 0xfffe || code > 0x10ffff;
    return !turns && !controls && !is_none;
}

/// The bytes of the character that the text starts with, if it is readable; or 0.
std::size_t character(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return is_readable(first) ? 1 : 0;
    if (!in(first, 0xc2, 0xf4)) return 0;
    const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    unsigned code = first & (0xffu >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
        code = (code << 6) | (byte(i) & 0x3f);
    }
    constexpr std::array<unsigned, 5> smallest{0, 0, 0x80, 0x800, 0x10000};
    return code >= smallest.at(size) && is_readable(code) ? size : 0;
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

std::string readable(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t size = character(text);
        if (size > 0)
            out += text.substr(0, size);
        else if (!text.starts_with("\r\n"))
            out += "\uFFFD";
        text.remove_prefix(size > 0 ? size : 1);
    }
    return out;
}

std::string one_line(std::string text) {
    const auto is_control = [](unsigned char c) { return c < ' ' || c == '\x7f'; };
    std::ranges::replace_if(text, is_control, '?');
    return readable(text);
}

}  // namespace rt
