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
std::string_view place_at(std::string_view sentence, std::size_t at) {
    const std::size_t end = sentence.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", at + 1);
    if (end == sentence.npos || end == at + 1 || sentence[end] != '}') return "";
    return sentence.substr(at, end + 1 - at);
}

/// A sentence with places, as the words before each of them and behind the last.
struct Pattern {
    std::string_view sentence;
    std::vector<std::string_view> words = {};
    std::vector<std::string_view> places = {};
    std::size_t length = 0;  ///< of the words
};

Pattern pattern_of(std::string_view sentence) {
    Pattern pattern{.sentence = sentence};
    std::size_t start = 0;  // of the words
    const auto end_words = [&](std::size_t end) {
        pattern.words.push_back(sentence.substr(start, end - start));
        pattern.length += pattern.words.back().size();
    };
    for (std::size_t at = sentence.find('{'); at != sentence.npos; at = sentence.find('{', at)) {
        const std::string_view place = place_at(sentence, at);
        if (place.empty()) {
            ++at;
            continue;
        }
        end_words(at);
        pattern.places.push_back(place.substr(1, place.size() - 2));
        at = start = at + place.size();
    }
    end_words(sentence.size());
    return pattern;
}

/// False for a sentence that any text may fit: "{what}, of {all}".
bool tells_apart(const Pattern& pattern) {
    constexpr int few = 4;
    int letters = 0;
    for (const std::string_view words : pattern.words)
        letters +=
            int(std::ranges::count_if(words, [](unsigned char c) { return std::isalpha(c) != 0; }));
    return !pattern.words.front().empty() || letters >= few;
}

/// The values in the pattern's places, each as short as possible, but not empty; or nothing if the
/// text does not fit.
Values values_in(const std::string& text, const Pattern& pattern) {
    const std::string_view end = pattern.words.back();
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
std::string unquoted(std::string_view line) {
    const std::size_t first = line.find('"');
    const std::size_t last = line.rfind('"');
    if (first == last) return "";
    line = line.substr(first + 1, last - first - 1);
    std::string text;
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t plain = std::min(line.find('\\', i), line.size());
        text += line.substr(i, plain - i);
        i = plain + 2;
        if (plain + 1 >= line.size()) continue;
        const char escaped = line[plain + 1];
        text += escaped == 'n' ? '\n' : escaped == 't' ? '\t' : escaped;
    }
    return text;
}

/// False if the text cannot fit the sentence: by what stands before its first and behind its last
/// brace, since most sentences end here.
bool may_fit(const std::string& text, std::string_view sentence) {
    const std::size_t open = sentence.find('{');
    const std::size_t close = sentence.rfind('}');
    return open < close && close != sentence.npos && text.starts_with(sentence.substr(0, open)) &&
           text.ends_with(sentence.substr(close + 1));
}

/// The same as tr_text, with the values translated so many times.
std::string translated(const std::string& text, int inside) {
    constexpr std::size_t longest = 2000;
    const auto found = translations().find(text);
    if (found != translations().end()) return found->second;
    Pattern best;
    Values values;
    for (const auto& [english, own] : translations()) {
        if (text.size() > longest || !may_fit(text, english)) continue;
        const Pattern pattern = pattern_of(english);
        if (pattern.length <= best.length || !tells_apart(pattern)) continue;
        Values those = values_in(text, pattern);
        if (those.empty()) continue;
        best = pattern;
        values = std::move(those);
    }
    if (values.empty()) return text;
    if (inside > 0)
        for (NamedValue& value : values) value.text = translated(value.text, inside - 1);
    return tr(std::string(best.sentence), values);
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

std::vector<CatalogueEntry> catalogue_entries(const std::string& catalogue) {
    std::vector<CatalogueEntry> entries;
    CatalogueEntry entry;
    std::string* text = nullptr;  // that the line's quotes belong to
    const auto end_entry = [&] {
        if (!entry.lines.empty()) entries.push_back(std::exchange(entry, {}));
        text = nullptr;
    };
    for (std::string_view rest = catalogue; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        if (line.empty()) {
            end_entry();
            continue;
        }
        entry.lines.append(line) += '\n';
        if (line.starts_with("#,") && line.find(", fuzzy") != line.npos) entry.is_fuzzy = true;
        if (line.starts_with("msg"))
            text = line.starts_with("msgid ")    ? &entry.english
                   : line.starts_with("msgstr ") ? &entry.own
                                                 : nullptr;
        if (text != nullptr) *text += unquoted(line);
    }
    end_entry();
    return entries;
}

std::vector<CatalogueEntry> translations_in(const std::filesystem::path& catalogue) {
    std::ifstream in(catalogue, std::ios::binary);
    std::vector<CatalogueEntry> entries =
        catalogue_entries(std::string(std::istreambuf_iterator<char>(in), {}));
    std::erase_if(entries, [](const CatalogueEntry& entry) {
        return entry.is_fuzzy || entry.english.empty() || entry.own.empty();
    });
    return entries;
}

void read_translations(const std::filesystem::path& catalogue) {
    for (const CatalogueEntry& entry : translations_in(catalogue))
        translations().insert({entry.english, entry.own});
}

void forget_translations() {
    translations().clear();
}

std::string tr(const std::string& english) {
    const auto found = translations().find(english);
    return found == translations().end() ? english : found->second;
}

std::string tr(const std::string& english, const Values& values) {
    const std::string sentence = tr(english);
    std::string text;
    for (std::size_t i = 0; i < sentence.size();) {
        const std::string_view place = sentence[i] == '{' ? place_at(sentence, i) : "";
        const auto value = std::ranges::find_if(values, [&](const NamedValue& each) {
            return place.size() > 2 && each.place == place.substr(1, place.size() - 2);
        });
        if (value == values.end()) {
            text += sentence[i++];
            continue;
        }
        text += value->text;
        i += place.size();
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
