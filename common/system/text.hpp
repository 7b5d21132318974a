// Texts: letters without case, lines, lists, numbers, the ending of a name.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The text with ASCII letters in lower case: names of files, keywords.
[[nodiscard]] inline std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

/// The lines without their ends.
[[nodiscard]] inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// The words between the blanks of the text.
[[nodiscard]] inline std::vector<std::string> words_of(const std::string& text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

/// The rest of the line after the word; nothing if the line does not start with it.
[[nodiscard]] inline std::optional<std::string> after(std::string_view word,
                                                      std::string_view line) {
    if (!line.starts_with(word)) return std::nullopt;
    return std::string(line.substr(word.size()));
}

/// "a, b, c": the items, or what `text` returns for each, with the separator between them.
template <class Items, class Text = std::identity>
[[nodiscard]] std::string joined(const Items& items, Text text = {},
                                 std::string_view separator = ", ") {
    std::string all;
    for (const auto& item : items) {
        if (!all.empty()) all += separator;
        all += std::invoke(text, item);
    }
    return all;
}

/// The text without blanks at its ends.
[[nodiscard]] inline std::string trimmed(std::string_view text) {
    constexpr std::string_view left_out = " \t\r";
    text.remove_prefix(std::min(text.find_first_not_of(left_out), text.size()));
    return std::string(text.substr(0, text.find_last_not_of(left_out) + 1));
}

/// Replaces the words wherever the text has them.
inline void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

/// The text that std::printf writes, of at most 511 bytes.
template <class... Values>
[[nodiscard]] std::string formatted(const char* format, Values... values) {
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

/// The first of these endings, as ".tar.gz", that the name has; nothing if it has none, or is an
/// ending alone.
template <std::size_t Count>
[[nodiscard]] std::string_view ending_of(const std::string& name,
                                         const std::array<std::string_view, Count>& endings) {
    for (const std::string_view ending : endings)
        if (name.size() > ending.size() && name.ends_with(ending)) return ending;
    return {};
}

}  // namespace rt
