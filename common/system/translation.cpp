#include "common/system/translation.hpp"

#include "common/system/text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

namespace rt {

namespace {

std::map<std::string, std::string>& translations() {
    static std::map<std::string, std::string> all;
    return all;
}

/// The place that begins there, with its braces: "{some}" of "{some} of {all}", or nothing.
std::string place_at(const std::string& sentence, std::size_t at) {
    if (sentence[at] != '{') return "";
    const std::size_t end = sentence.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", at + 1);
    if (end == std::string::npos || end == at + 1 || sentence[end] != '}') return "";
    return sentence.substr(at, end + 1 - at);
}

/// A sentence with places, as the words before each of them and behind the last.
struct Pattern {
    std::string sentence;
    std::vector<std::string> words = {""};
    std::vector<std::string> places = {};
    std::size_t length = 0;  ///< of the words
};

std::vector<Pattern>& patterns() {
    static std::vector<Pattern> all;
    return all;
}

Pattern pattern_of(const std::string& sentence) {
    Pattern pattern{.sentence = sentence};
    for (std::size_t i = 0; i < sentence.size();) {
        const std::string place = place_at(sentence, i);
        if (place.empty()) {
            pattern.words.back() += sentence[i++];
            ++pattern.length;
            continue;
        }
        pattern.places.push_back(place.substr(1, place.size() - 2));
        pattern.words.emplace_back();
        i += place.size();
    }
    return pattern;
}

/// False for a sentence that any text may fit: "{what}, of {all}".
bool tells_apart(const Pattern& pattern) {
    constexpr int few = 4;
    int letters = 0;
    for (const std::string& words : pattern.words)
        letters += int(std::count_if(words.begin(), words.end(),
                                     [](unsigned char c) { return std::isalpha(c) != 0; }));
    return !pattern.words.front().empty() || letters >= few;
}

/// The values in the pattern's places, each as short as possible, but not empty; or nothing if the
/// text does not fit.
Values values_in(const std::string& text, const Pattern& pattern) {
    const std::string& end = pattern.words.back();
    if (!text.starts_with(pattern.words.front()) || !text.ends_with(end)) return {};
    Values values;
    std::size_t at = pattern.words.front().size();
    for (std::size_t i = 0; i < pattern.places.size(); ++i) {
        const bool is_last = i + 1 == pattern.places.size();
        const std::size_t next =
            is_last ? text.size() - end.size() : text.find(pattern.words[i + 1], at + 1);
        if (next == std::string::npos || next <= at) return {};
        values.emplace_back(pattern.places[i], text.substr(at, next - at));
        at = next + pattern.words[i + 1].size();
    }
    return values;
}

/// The text of a line's quotes: "a \"word\"\n".
std::string unquoted(const std::string& line) {
    std::string text;
    const std::size_t first = line.find('"');
    const std::size_t last = line.rfind('"');
    for (std::size_t i = first + 1; i < last; ++i) {
        if (line[i] != '\\') {
            text += line[i];
            continue;
        }
        ++i;
        text += line[i] == 'n' ? '\n' : line[i] == 't' ? '\t' : line[i];
    }
    return text;
}

void add_translation(const std::string& english, const std::string& own) {
    translations().insert({english, own});
    Pattern pattern = pattern_of(english);
    if (!pattern.places.empty() && tells_apart(pattern)) patterns().push_back(std::move(pattern));
}

/// The same as tr_text, with the values translated so many times.
std::string translated(const std::string& text, int inside) {
    constexpr std::size_t longest = 2000;
    const auto found = translations().find(text);
    if (found != translations().end()) return found->second;
    const Pattern* best = nullptr;
    Values values;
    for (const Pattern& pattern : patterns()) {
        if (text.size() > longest || (best != nullptr && pattern.length <= best->length)) continue;
        Values those = values_in(text, pattern);
        if (those.empty()) continue;
        best = &pattern;
        values = std::move(those);
    }
    if (best == nullptr) return text;
    if (inside > 0)
        for (auto& [place, value] : values) value = translated(value, inside - 1);
    return tr(best->sentence, values);
}

}  // namespace

std::string language_of_environment() {
    for (const char* name : {"RAYSTEPS_LANG", "LC_ALL", "LC_MESSAGES", "LANG"})
        if (const char* value = std::getenv(name); value != nullptr && *value != '\0') {
            const std::string locale = value;
            return locale.substr(0, locale.find_first_of("_.@"));
        }
    return "";
}

std::vector<std::string> catalogue_entries(const std::string& catalogue) {
    std::vector<std::string> entries(1);
    for (const std::string& line : lines_of(catalogue)) {
        if (!line.empty())
            entries.back() += line + "\n";
        else if (!entries.back().empty())
            entries.emplace_back();
    }
    if (entries.back().empty()) entries.pop_back();
    return entries;
}

std::string catalogue_text(const std::string& entry, const std::string& keyword) {
    std::string text;
    bool inside = false;
    for (const std::string& line : lines_of(entry)) {
        if (line.starts_with("msg")) inside = line.starts_with(keyword + " ");
        if (inside) text += unquoted(line);
    }
    return text;
}

std::vector<std::pair<std::string, std::string>> translations_in(
    const std::filesystem::path& catalogue) {
    std::vector<std::pair<std::string, std::string>> found;
    std::ifstream in(catalogue, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (const std::string& entry : catalogue_entries(text)) {
        const std::string flags = entry.substr(0, entry.find("msgid"));
        const std::string english = catalogue_text(entry, "msgid");
        const std::string own = catalogue_text(entry, "msgstr");
        if (flags.find(", fuzzy") == std::string::npos && !english.empty() && !own.empty())
            found.emplace_back(english, own);
    }
    return found;
}

void read_translations(const std::filesystem::path& catalogue) {
    for (const auto& [english, own] : translations_in(catalogue)) add_translation(english, own);
}

void forget_translations() {
    translations().clear();
    patterns().clear();
}

std::string tr(const std::string& english) {
    const auto found = translations().find(english);
    return found == translations().end() ? english : found->second;
}

std::string tr(const std::string& english, const Values& values) {
    const std::string sentence = tr(english);
    std::string text;
    for (std::size_t i = 0; i < sentence.size();) {
        const auto stands_here = [&](const auto& value) {
            return sentence.compare(i, value.first.size() + 2,
                                    "{" + std::string(value.first) + "}") == 0;
        };
        std::size_t which = 0;
        while (which < values.size() && !stands_here(values[which])) ++which;
        if (which == values.size()) {
            text += sentence[i++];
            continue;
        }
        text += values[which].second;
        i += values[which].first.size() + 2;
    }
    return text;
}

std::string tr_text(const std::string& text) {
    constexpr int most_inside = 4;  // values in values: the text may be a stranger's
    return translated(text, most_inside);
}

std::string tr_line(const std::string& line) {
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    return line.substr(0, start) + tr_text(line.substr(start));
}

std::string tr_lines(const std::string& text) {
    std::string own;
    for (const std::string& line : lines_of(text)) own += tr_line(line) + "\n";
    if (!own.empty() && !text.ends_with('\n')) own.pop_back();
    return own;
}

std::string paragraphs_translated(const std::string& english) {
    std::string text;
    std::string paragraph;
    const auto end_paragraph = [&] {
        text += tr(paragraph);
        paragraph.clear();
    };
    for (const std::string& line : lines_of(english)) {
        if (line.empty()) {
            end_paragraph();
            text += '\n';
        } else {
            paragraph += line + "\n";
        }
    }
    end_paragraph();
    return text;
}

}  // namespace rt
