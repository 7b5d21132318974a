#include "docs/figures/source/typeset.hpp"

namespace rt::figures {

namespace {

/// The bytes of the UTF-8 character at the text's beginning.
std::string_view first_character(std::string_view text) {
    std::size_t size = 1;
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) ++size;
    return text.substr(0, size);
}

bool is_letter(std::string_view character) {
    const char c = character.front();
    if (character.size() == 1) return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return character >= "α" && character <= "ω";
}

/// The letters at the beginning of the text, or else its first character.
std::string_view first_word(std::string_view text) {
    std::size_t size = 0;
    while (size < text.size() && is_letter(first_character(text.substr(size))))
        size += first_character(text.substr(size)).size();
    return size == 0 ? first_character(text) : text.substr(0, size);
}

bool is_symbol(std::string_view word) {
    return is_letter(first_character(word)) && first_character(word) == word;
}

void set_mathematics(std::string_view text, int script, std::vector<Run>& runs) {
    while (!text.empty()) {
        const char c = text.front();
        if (c == '_' || c == '^') {
            const bool group = text[1] == '{';
            const std::string_view inside =
                group ? text.substr(2, text.find('}') - 2) : first_character(text.substr(1));
            set_mathematics(inside, c == '_' ? -1 : 1, runs);
            text.remove_prefix(1 + inside.size() + (group ? 2 : 0));
            continue;
        }
        const std::string_view word = first_word(text);
        runs.push_back({.text = std::string(word), .italic = is_symbol(word), .script = script});
        text.remove_prefix(word.size());
    }
}

/// Joins neighbors with the same style.
std::vector<Run> joined(const std::vector<Run>& runs) {
    std::vector<Run> result;
    for (const Run& run : runs) {
        const bool alike = !result.empty() && result.back().italic == run.italic &&
                           result.back().script == run.script;
        if (alike)
            result.back().text += run.text;
        else
            result.push_back(run);
    }
    return result;
}

}  // namespace

std::vector<Run> typeset(std::string_view label) {
    std::vector<Run> runs;
    bool mathematics = false;
    while (true) {
        const std::size_t end = label.find('$');
        const std::string_view part = label.substr(0, end);
        if (mathematics)
            set_mathematics(part, 0, runs);
        else if (!part.empty())
            runs.push_back({.text = std::string(part)});
        if (end == std::string_view::npos) return joined(runs);
        label.remove_prefix(end + 1);
        mathematics = !mathematics;
    }
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += c;
    }
    return result;
}

}  // namespace rt::figures
