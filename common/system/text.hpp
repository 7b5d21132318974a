// Texts: letters without case, lines, numbers, the ending of a name.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
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
