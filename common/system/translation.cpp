#include "common/system/translation.hpp"

#include "common/system/files.hpp"

#include <cstdlib>
#include <map>

namespace rt {

namespace {

std::map<std::string, std::string>& translations() {
    static std::map<std::string, std::string> all;
    return all;
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

void read_translations(const std::filesystem::path& catalogue) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(catalogue, none)) return;
    for (const std::string& entry : catalogue_entries(read_text(catalogue))) {
        const std::string flags = entry.substr(0, entry.find("msgid"));
        const std::string english = catalogue_text(entry, "msgid");
        const std::string own = catalogue_text(entry, "msgstr");
        if (flags.find(", fuzzy") == std::string::npos && !english.empty() && !own.empty())
            translations().insert({english, own});
    }
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
