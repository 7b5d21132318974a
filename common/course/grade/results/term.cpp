#include "common/course/grade/results/term.hpp"

#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/roster.hpp"
#include "common/course/grade/results/submissions.hpp"
#include "common/stages/stages.hpp"
#include "common/system/hash.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <array>

namespace rt::grade {

namespace {

constexpr double most_points_by_hand = 1e6;

Students students_of(const std::vector<Mark>& marks, const Students& others) {
    Students all = others;
    for (const Mark& mark : marks) all.insert(mark.student);
    return all;
}

/// Reads the files that the settings name.
class Reading {
public:
    Reading(const fs::path& file, const std::vector<Mark>& marks, const Students& others)
        : settings_(read_settings(file)),
          marks_(marks),
          submitted_(students_of(marks, others)),
          graded_(graded_stages(marks)) {
        term_.names = StudentNames(submitted_);
        term_.weights = settings_.weights;
        term_.bonus = settings_.bonus;
        term_.late_percent = settings_.number("late percent", 100);
        term_.additions_of = settings_.number("additions of", most_points_by_hand);
        term_.out_of = settings_.number("out of", most_points_by_hand);
        const auto anonymous = settings_.words.find("anonymous");
        term_.anonymous = anonymous != settings_.words.end() && anonymous->second.value == "yes";
        if (const auto lang = settings_.words.find("lang"); lang != settings_.words.end()) {
            term_.language = lang->second.value;
            term_.language_place = settings_.place("lang");
        }
        read_roster();
        read_late();
        read_overrides();
        read_additions();
        if (term_.roster) report_strangers(*term_.roster);
    }

    [[nodiscard]] Term term() { return std::move(term_); }

private:
    void read_roster() {
        std::optional<Csv> csv = settings_.table("roster");
        if (!csv) return;
        Headings headings;
        for (const auto& [word, setting] : settings_.words) headings[word] = setting.value;
        Roster roster = roster_of(std::move(*csv), headings);
        find_students(roster, term_.names, submitted_);
        check_maximum(roster);
        if (roster.group != -1) share(roster);
        for (const std::string& each : roster.problems) term_.notes.push_back(each);
        for (std::size_t i = 0; i < roster.students.size(); ++i) {
            const Csv::Row& row = roster.csv.rows[i];
            if (roster.students[i].empty()) continue;
            term_.names.add(row.at(roster.student), roster.students[i]);
            term_.names.add(roster.name_in(row), roster.students[i]);
        }
        term_.roster = std::move(roster);
    }

    /// The sheet's own maximum is the platform's, which refuses more.
    void check_maximum(Roster& roster) {
        for (std::size_t i = 0; i < roster.students.size(); ++i) {
            const Csv::Row& row = roster.csv.rows[i];
            const std::optional<double> most = roster.maximum_of(row);
            if (roster.students[i].empty()) continue;
            if (!most && roster.maximum != -1)
                add_note(
                    roster.csv, row,
                    "\"" + row.at(roster.maximum) + "\" is no maximum: its grade is not scaled");
            if (most && term_.out_of > 0 && *most != term_.out_of)
                throw InputError(
                    settings_.place("out of"),
                    "the roster has its own maximum, " + number(*most) + ": leave \"out of\" away");
        }
    }

    /// Gives the members of each group who have submitted nothing the submission of one who has.
    void share(const Roster& roster) {
        std::map<std::string, Students> members;
        std::map<std::string, std::string> titles;
        for (std::size_t i = 0; i < roster.students.size(); ++i) {
            const std::string group = trimmed(roster.csv.rows[i].at(roster.group));
            if (group.empty() || roster.students[i].empty()) continue;
            members[folded(group)].insert(roster.students[i]);
            titles[folded(group)] = group;
        }
        for (const auto& [group, students] : members) share(titles[group], students);
    }

    void share(const std::string& group, const Students& members) {
        Students sources = term_.names.named(group);  // a folder with the group's name
        for (const std::string& each : sources)
            if (members.count(each) == 0) term_.groups.insert(each);
        Students without;
        for (const std::string& each : members)
            (submitted_.count(each) == 1 ? sources : without).insert(each);
        if (sources.empty()) return;
        const std::string source = *std::ranges::max_element(
            sources, {}, [&](const std::string& each) { return points_of(each); });
        for (const std::string& each : without) term_.shared[each] = {source, group};
        if (sources.size() == 1) return;
        term_.notes.push_back(
            "group \"" + group + "\" has several submissions, of " + joined(sources) +
            ": each counts for its own student" +
            (without.empty() ? "" : ", and that of " + source + " for the others"));
    }

    [[nodiscard]] int points_of(const std::string& student) const {
        int sum = 0;
        for (const Mark& mark : marks_)
            if (mark.student == student) sum += mark.points();
        return sum;
    }

    void report_strangers(const Roster& roster) {
        Students strangers = submitted_;
        for (const std::string& student : roster.students) strangers.erase(student);
        for (const std::string& group : term_.groups) strangers.erase(group);
        for (const std::string& student : strangers)
            term_.notes.push_back(student + ": submitted, but is not on the roster");
    }

    /// The student of a row; nothing, with a note, if no student matches.
    std::optional<std::string> student_of(const Csv& csv, const Csv::Row& row, int column) {
        std::optional<std::string> student =
            term_.names.find(row.at(column), {csv.file.string(), row.line});
        if (!student) add_note(csv, row, "there is no student \"" + row.at(column) + "\"");
        return student;
    }

    void add_note(const Csv& csv, const Csv::Row& row, const std::string& words) {
        term_.notes.push_back(csv.file.filename().string() + ":" + std::to_string(row.line) + ": " +
                              words);
    }

    void read_late() {
        const std::optional<Csv> csv = settings_.table("late");
        if (!csv) return;
        const int who = csv->wanted({"student"});
        const int days = csv->wanted({"days", "days late", "days_late"});
        constexpr double most = 366;
        for (const Csv::Row& row : csv->rows) {
            const FileLocation place{csv->file.string(), row.line};
            const double late = read_number(row.at(days), place, 0, most);
            const auto student = student_of(*csv, row, who);
            if (student && !term_.days_late.emplace(*student, late).second)
                throw InputError(place, *student + " is listed already");
        }
    }

    void read_overrides() {
        const std::optional<Csv> csv = settings_.table("overrides");
        if (!csv) return;
        const int who = csv->wanted({"student"});
        const int stage = csv->wanted({"stage"});
        const int points = csv->wanted({"points"});
        const int comment = csv->column({"comment"});
        for (const Csv::Row& row : csv->rows) {
            const FileLocation place{csv->file.string(), row.line};
            const bool all = lower_case(trimmed(row.at(stage))) == "total";
            const int of = all ? Term::total : read_stage(row.at(stage), place);
            PointsByHand given{.comment = row.at(comment)};
            given.excused = lower_case(trimmed(row.at(points))) == "excused";
            if (given.excused && all)
                throw InputError(place, "a total cannot be excused: list its stages");
            if (!given.excused)
                given.points = read_number(row.at(points), place, 0, most_points_by_hand);
            const auto student = student_of(*csv, row, who);
            if (student && !term_.overrides.emplace(std::pair(*student, of), given).second)
                throw InputError(place, *student + " is listed already with this stage");
            if (student) check_override(*csv, row, of, given.points);
        }
    }

    /// Points of a stage without marks count nowhere, and too many may be a slip: both are allowed.
    void check_override(const Csv& csv, const Csv::Row& row, int stage, double points) {
        const bool is_total = stage == Term::total;
        if (!is_total && graded_.count(stage) == 0)
            return add_note(csv, row, name_of(stage) + " is not graded: its points do not count");
        double most = is_total ? term_.additions_of : graded_[stage];
        if (is_total)
            for (const auto& [each, of_stage] : graded_) most += of_stage * term_.weight(each);
        if (points > most)
            add_note(csv, row,
                     number(points) + " points are more than the " + number(most) + " of " +
                         (is_total ? "all stages" : name_of(stage)) + "; they count");
    }

    void read_additions() {
        const std::optional<Csv> csv = settings_.table("additions");
        if (!csv) return;
        const int who = csv->wanted({"student"});
        const int points = csv->wanted({"points"});
        const int comment = csv->column({"comment"});
        for (const Csv::Row& row : csv->rows) {
            const PointsByHand given{read_number(row.at(points), {csv->file.string(), row.line},
                                                 -most_points_by_hand, most_points_by_hand),
                                     row.at(comment)};
            if (const auto student = student_of(*csv, row, who))
                term_.additions[*student].push_back(given);
        }
    }

    Settings settings_;
    const std::vector<Mark>& marks_;
    Students submitted_;         ///< the students with a submission
    std::map<int, int> graded_;  ///< the stages with marks, and their points
    Term term_;
};

}  // namespace

double Term::weight(int stage) const {
    const auto found = weights.find(stage);
    return found == weights.end() ? 1 : found->second;
}

bool Term::is_excused(const std::string& student, int stage) const {
    const auto found = overrides.find({student, stage});
    return found != overrides.end() && found->second.excused;
}

std::string Term::called(const std::string& student) const {
    if (!anonymous) return student;
    return formatted("s-%08x",
                     unsigned(keyed_hash({key, 0x616e6f6e796d6f75u}, student) & 0xffffffffu));
}

Term read_term(const fs::path& results, const std::vector<Mark>& marks, const Students& others) {
    const fs::path file = results / "term.txt";
    if (fs::exists(file)) return Reading(file, marks, others).term();
    Term term;
    term.names = StudentNames(students_of(marks, others));
    return term;
}

namespace {

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
    const bool is_known = std::ranges::find(once, word) != once.end();
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
