#include "common/course/grade/results/settings.hpp"

#include "common/course/grade/results/any_text.hpp"
#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/roster.hpp"
#include "common/course/grade/results/submissions.hpp"

#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/lower_case.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <array>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

// All but "weight" and "bonus", which may be repeated.
constexpr std::array once = {"roster",       "student", "name",      "group",        "grade",
                             "maximum",      "comment", "late",      "late percent", "additions",
                             "additions of", "out of",  "overrides", "anonymous",    "lang"};

void read_weight(Settings& settings, const std::string& value, const FileLocation& place) {
    const std::size_t blank = value.find_last_of(" \t");
    if (blank == std::string::npos)
        throw InputError(place, "a weight needs a stage: \"weight: 5 2\"");
    constexpr double most = 1000;
    const int stage = read_stage(value.substr(0, blank), place);
    const double weight = read_number(value.substr(blank + 1), place, 0, most);
    if (!settings.weights.emplace(stage, weight).second)
        throw InputError(place, "stage " + std::to_string(stage) + " has a weight already");
}

void read_line(Settings& settings, const std::string& line, const FileLocation& place) {
    const std::size_t colon = line.find(':');
    const std::string word = lower_case(trimmed(line.substr(0, colon)));
    const std::string value = colon == std::string::npos ? "" : trimmed(line.substr(colon + 1));
    if (value.empty()) throw InputError(place, "\"" + line + "\" is not \"word: value\"");
    const bool is_known = std::find(once.begin(), once.end(), word) != once.end();
    if (word == "weight")
        read_weight(settings, value, place);
    else if (word == "bonus")
        settings.bonus[read_stage(value, place)] = true;
    else if (!is_known || (word == "anonymous" && value != "yes" && value != "no"))
        throw InputError(place, "\"" + line +
                                    "\" is no setting: roster, student, name, group, grade, "
                                    "maximum, comment, weight, bonus, late, late percent, "
                                    "additions, additions of, overrides, out of, anonymous: yes, "
                                    "lang: fr");
    else if (!settings.words.emplace(word, Settings::Word{value, place.line}).second)
        throw InputError(place, "\"" + word + "\" is set already");
}

}  // namespace

FileLocation Settings::place(const std::string& word) const {
    const auto found = words.find(word);
    return {file.string(), found == words.end() ? 0 : found->second.line};
}

double Settings::number(const std::string& word, double most) const {
    const auto found = words.find(word);
    return found == words.end() ? 0 : read_number(found->second.value, place(word), 0, most);
}

std::optional<Csv> Settings::table(const std::string& word) const {
    const auto found = words.find(word);
    if (found == words.end()) return std::nullopt;
    const fs::path table = file.parent_path() / found->second.value;
    for (const char* report : report_files)
        if (table.lexically_normal() == (file.parent_path() / report).lexically_normal())
            throw InputError(place(word), std::string(report) +
                                              " is a report that grading writes: rename the file");
    if (!fs::is_regular_file(table))
        throw InputError(place(word), "there is no file " + table.string());
    return read_csv(table);
}

Settings read_settings(const fs::path& file) {
    Settings settings{.file = file};
    const std::vector<std::string> lines = lines_of(read_any_text(file).text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string line = trimmed(lines[i]);
        if (!line.empty() && line[0] != '#') read_line(settings, line, {file.string(), int(i) + 1});
    }
    return settings;
}

double read_number(const std::string& text, const FileLocation& place, double least, double most) {
    const std::optional<double> value = number_of(text);
    if (!value || *value < least || *value > most)
        throw InputError(
            place, "\"" + text + "\" is no number from " + number(least) + " to " + number(most));
    return *value;
}

int read_stage(const std::string& text, const FileLocation& place) {
    const std::optional<int> stage = find_stage(trimmed(text));
    if (!stage) throw InputError(place, "no stage \"" + text + "\"");
    return *stage;
}

}  // namespace rt::grade
