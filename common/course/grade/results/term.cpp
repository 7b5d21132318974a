#include "common/course/grade/results/term.hpp"

#include "common/course/grade/judging/source_names.hpp"
#include "common/course/grade/results/student_names.hpp"
#include "common/course/grade/results/submissions.hpp"

#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/keyed_hash.hpp"
#include "common/system/lower_case.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr const char* end_of_line = "\r\n";

/// "7,5" too, as some spreadsheets write it.
std::optional<double> number_of(std::string text) {
    text = trimmed(text);
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

double read_number(const std::string& text, const FileLocation& place, double most) {
    const std::optional<double> value = number_of(text);
    if (!value || *value < 0 || *value > most)
        throw InputError(place, "\"" + text + "\" is no number from 0 to " + number(most));
    return *value;
}

int read_stage(const std::string& text, const FileLocation& place) {
    const std::optional<int> stage = find_stage(trimmed(text));
    if (!stage) throw InputError(place, "no stage \"" + text + "\"");
    return *stage;
}

/// Reads the lines "word: value" of the settings, and then the files that they name.
class Reading {
public:
    Reading(const fs::path& file, const std::vector<Mark>& marks)
        : file_(file), names_(marks), graded_(graded_stages(marks)) {
        const std::vector<std::string> lines = lines_of(read_any_text(file));
        for (std::size_t i = 0; i < lines.size(); ++i) {
            line_ = int(i) + 1;
            const std::string line = trimmed(lines[i]);
            if (!line.empty() && line[0] != '#') read_line(line);
        }
        read_roster();
        read_late();
        read_overrides();
    }

    [[nodiscard]] Term term() { return std::move(term_); }

private:
    [[nodiscard]] FileLocation place() const { return {file_.string(), line_}; }

    void read_line(const std::string& line) {
        const std::size_t colon = line.find(':');
        const std::string word = lower_case(trimmed(line.substr(0, colon)));
        const std::string value = colon == std::string::npos ? "" : trimmed(line.substr(colon + 1));
        const std::set<std::string> texts = {"roster",  "late",  "overrides",
                                             "student", "grade", "comment"};
        if (value.empty()) throw InputError(place(), "\"" + line + "\" is not \"word: value\"");
        const bool is_repeated = word == "weight" || word == "bonus";
        if (!is_repeated && !words_.insert(word).second)
            throw InputError(place(), "\"" + word + "\" is set already");
        if (texts.count(word) == 1)
            settings_[word] = {value, line_};
        else if (word == "late percent")
            term_.late_percent = read_number(value, place(), 100);
        else if (word == "out of")
            term_.out_of = read_number(value, place(), 1e6);
        else if (word == "bonus")
            term_.bonus[read_stage(value, place())] = true;
        else if (word == "weight")
            read_weight(value);
        else if (word == "anonymous" && (value == "yes" || value == "no"))
            term_.anonymous = value == "yes";
        else
            throw InputError(place(), "\"" + line +
                                          "\" is no setting: roster, student, grade, comment, "
                                          "weight, bonus, late, late percent, overrides, out of, "
                                          "anonymous: yes");
    }

    void read_weight(const std::string& value) {
        const std::size_t blank = value.find_last_of(" \t");
        if (blank == std::string::npos)
            throw InputError(place(), "a weight needs a stage: \"weight: 5 2\"");
        constexpr double most = 1000;
        const int stage = read_stage(value.substr(0, blank), place());
        const double weight = read_number(value.substr(blank + 1), place(), most);
        if (!term_.weights.emplace(stage, weight).second)
            throw InputError(place(), "stage " + std::to_string(stage) + " has a weight already");
    }

    /// The table that a setting names, beside term.txt; nothing if there is no such setting.
    std::optional<Csv> table(const std::string& word) {
        const auto found = settings_.find(word);
        if (found == settings_.end()) return std::nullopt;
        line_ = found->second.second;
        const fs::path file = file_.parent_path() / found->second.first;
        for (const char* report : report_files)
            if (file.lexically_normal() == (file_.parent_path() / report).lexically_normal())
                throw InputError(place(), std::string(report) +
                                              " is a report that grading writes: rename the file");
        if (!fs::is_regular_file(file))
            throw InputError(place(), "there is no file " + file.string());
        return read_csv(file);
    }

    static int wanted(const Csv& csv, const std::vector<std::string>& headings) {
        const int column = csv.column(headings);
        if (column == -1)
            throw InputError({csv.file.string(), csv.head.line},
                             "has no column \"" + headings.front() + "\"");
        return column;
    }

    std::string setting(const std::string& word, const std::string& otherwise) {
        const auto found = settings_.find(word);
        return found == settings_.end() ? otherwise : found->second.first;
    }

    void read_roster() {
        std::optional<Csv> csv = table("roster");
        if (!csv) return;
        const bool moodle = csv->column({"Identifier"}) != -1;
        const bool canvas = !moodle && csv->column({"SIS Login ID", "SIS User ID"}) != -1;
        Roster roster{.csv = std::move(*csv)};
        const std::string by = setting("student", "");
        roster.student =
            by.empty() ? wanted(roster.csv, moodle   ? std::vector<std::string>{"Identifier"}
                                            : canvas ? std::vector<std::string>{"ID"}
                                                     : std::vector<std::string>{"student", "name"})
                       : wanted(roster.csv, {by});
        roster.name = roster.csv.column({"Full name", canvas ? "Student" : "Name", "Name"});
        roster.grade = setting("grade", moodle ? "Grade" : "Raysteps");
        roster.comment = setting("comment", moodle ? "Feedback comments" : "");
        if (settings_.count("comment") == 1) (void)wanted(roster.csv, {roster.comment});
        const bool has_identifiers = moodle || canvas;
        std::set<std::string> there;
        for (const Csv::Row& row : roster.csv.rows) {
            const std::string who = row.at(roster.student);
            const std::string name = row.at(roster.name);
            const FileLocation place{roster.csv.file.string(), row.line};
            std::optional<std::string> student;
            if (!folded(who).empty())
                student =
                    has_identifiers ? names_.find_identifier(who, place) : names_.find(who, place);
            if (!student && !name.empty()) {
                student = names_.find(name, place);
                if (student && there.count(*student) == 1) student.reset();  // a namesake
            }
            if (!student && is_person(row, roster)) {
                student = folded(name.empty() ? who : name);
                const std::string id = number_at_end(trimmed(who));
                if (!name.empty() && !id.empty()) *student += "_" + id;
                if (there.count(*student) == 1) student = folded(who);
            }
            if (student && !there.insert(*student).second)
                throw InputError(place,
                                 "\"" + who + "\" is " + *student + ", who is listed already");
            roster.students.push_back(student.value_or(""));
            if (!student) continue;
            names_.add(who, *student);
            names_.add(name, *student);
        }
        on_roster_ = std::move(there);
        term_.roster = std::move(roster);
    }

    /// Canvas's second line has the points possible, and a last one is a test student's.
    static bool is_person(const Csv::Row& row, const Roster& roster) {
        const std::string first = lower_case(trimmed(row.at(0)));
        return !trimmed(row.at(roster.student)).empty() && first != "points possible" &&
               first != "student, test";
    }

    /// The student of a row; nothing, with a note, if no student matches.
    std::optional<std::string> student_of(const Csv& csv, const Csv::Row& row, int column) {
        std::optional<std::string> student =
            names_.find(row.at(column), {csv.file.string(), row.line});
        if (!student) add_note(csv, row, "there is no student \"" + row.at(column) + "\"");
        return student;
    }

    void add_note(const Csv& csv, const Csv::Row& row, const std::string& words) {
        term_.notes.push_back(csv.file.filename().string() + ":" + std::to_string(row.line) + ": " +
                              words);
    }

    void read_late() {
        const std::optional<Csv> csv = table("late");
        if (!csv) return;
        const int who = wanted(*csv, {"student"});
        const int days = wanted(*csv, {"days", "days late", "days_late"});
        constexpr double most = 366;
        for (const Csv::Row& row : csv->rows) {
            const FileLocation place{csv->file.string(), row.line};
            const double late = read_number(row.at(days), place, most);
            const auto student = student_of(*csv, row, who);
            if (student && !term_.days_late.emplace(*student, late).second)
                throw InputError(place, *student + " is listed already");
        }
    }

    void read_overrides() {
        const std::optional<Csv> csv = table("overrides");
        if (!csv) return;
        const int who = wanted(*csv, {"student"});
        const int stage = wanted(*csv, {"stage"});
        const int points = wanted(*csv, {"points"});
        const int comment = csv->column({"comment"});
        constexpr double most = 1e6;
        for (const Csv::Row& row : csv->rows) {
            const FileLocation place{csv->file.string(), row.line};
            const bool all = lower_case(trimmed(row.at(stage))) == "total";
            const int of = all ? Term::total : read_stage(row.at(stage), place);
            const Override given{read_number(row.at(points), place, most), row.at(comment)};
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
            return add_note(csv, row,
                            stage_title(stage) + " is not graded: its points do not count");
        double most = is_total ? 0 : graded_[stage];
        if (is_total)
            for (const auto& [each, of_stage] : graded_) most += of_stage * term_.weight(each);
        if (points > most)
            add_note(csv, row,
                     number(points) + " points are more than the " + number(most) + " of " +
                         (is_total ? "all stages" : stage_title(stage)) + "; they count");
    }

public:
    /// Reports students with a submission who are not on the roster.
    void report_strangers(const std::vector<Mark>& marks) {
        if (!term_.roster) return;
        std::set<std::string> strangers;
        for (const Mark& mark : marks)
            if (on_roster_.count(mark.student) == 0) strangers.insert(mark.student);
        for (const std::string& student : strangers)
            term_.notes.push_back(student + ": submitted, but is not on the roster");
    }

private:
    fs::path file_;
    int line_ = 0;
    std::map<std::string, std::pair<std::string, int>> settings_;
    std::set<std::string> words_;  ///< of all settings that may be there once
    StudentNames names_;
    std::map<int, int> graded_;  ///< the stages with marks, and their points
    std::set<std::string> on_roster_;
    Term term_;
};

}  // namespace

double Term::weight(int stage) const {
    const auto found = weights.find(stage);
    return found == weights.end() ? 1 : found->second;
}

std::string Term::called(const std::string& student) const {
    if (!anonymous) return student;
    char text[16];
    std::snprintf(text, sizeof text, "s-%08x",
                  unsigned(keyed_hash({key, 0x616e6f6e796d6f75u}, student) & 0xffffffffu));
    return text;
}

Term read_term(const fs::path& results, const std::vector<Mark>& marks) {
    const fs::path file = results / "term.txt";
    if (!fs::exists(file)) return {};
    Reading reading(file, marks);
    reading.report_strangers(marks);
    return reading.term();
}

void write_upload(const fs::path& results, const std::vector<Mark>& marks, const Term& term) {
    std::error_code none;
    if (term.anonymous) {
        std::string names = std::string("called,student") + end_of_line;
        for (const StudentMarks& each : submissions(marks, term))
            names += each.called + "," + cell(each.student) + end_of_line;
        write_text(results / "names.csv", names);
    } else {
        fs::remove(results / "names.csv", none);
    }
    if (!term.roster) {
        fs::remove(results / "upload.csv", none);
        return;
    }
    const Roster& roster = *term.roster;
    std::map<std::string, StudentMarks> by_student;
    for (StudentMarks& each : submissions(marks, term)) by_student[each.student] = std::move(each);
    const Csv& csv = roster.csv;
    int width = int(csv.head.cells.size());
    // Only the columns of Canvas that identify the student: it would import the others as grades.
    if (const int section = csv.column({"Section"});
        section != -1 && csv.column({"SIS Login ID", "SIS User ID"}) != -1)
        width = section + 1;
    int grade = csv.column({roster.grade});
    std::vector<int> columns;
    for (int i = 0; i < width; ++i) columns.push_back(i);
    if (grade == -1 || grade >= width) columns.push_back(grade);
    const int comment = roster.comment.empty() ? -1 : csv.column({roster.comment});
    const int most = csv.column({"Maximum Grade"});
    const double of = most_points(graded_stages(marks), term);
    std::string text;
    const auto add = [&](const Csv::Row& row, const std::string& points,
                         const std::string& remarks) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            std::string value = row.at(columns[i]);
            if (columns[i] == grade) value = points;
            if (columns[i] == comment && comment != -1 && !remarks.empty()) value = remarks;
            text +=
                (i == 0 ? "" : std::string(1, csv.separator)) + plain_cell(value, csv.separator);
        }
        text += end_of_line;
    };
    add(csv.head, roster.grade, roster.comment);
    for (std::size_t i = 0; i < csv.rows.size(); ++i) {
        const Csv::Row& row = csv.rows[i];
        const double possible =
            term.out_of > 0 ? term.out_of : number_of(row.at(most)).value_or(of);
        const auto found = by_student.find(roster.students[i]);
        if (found != by_student.end()) {
            // Moodle accepts no grade above its maximum, for example with a bonus.
            double points = of > 0 ? found->second.points * possible / of : 0;
            if (most != -1) points = std::min(points, possible);
            add(row, number(points), found->second.remarks);
        } else
            add(row, lower_case(trimmed(row.at(0))) == "points possible" ? number(possible) : "",
                "");
    }
    write_text(results / "upload.csv", text);
}

}  // namespace rt::grade
