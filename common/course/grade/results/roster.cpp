#include "common/course/grade/results/roster.hpp"

#include "common/system/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace rt::grade {

namespace {

/// The headings of Moodle's grading worksheet in one language, from its language packs.
struct Worksheet {
    const char* student;
    const char* name;
    const char* grade;
    const char* maximum;
    const char* comment;
};

constexpr std::array<Worksheet, 4> worksheets = {{
    {"Identifier", "Full name", "Grade", "Maximum grade", "Feedback comments"},
    {"Identifiant", "Nom complet", "Note", "Note maximale", "Feedback par commentaires"},
    {"ID", "Vollständiger Name", "Bewertung", "Bestwertung", "Feedback als Kommentar"},
    {"Identificador", "Nombre completo", "Calificación", "Calificación máxima",
     "Comentarios de retroalimentación"},
}};

const Worksheet* worksheet_of(const Csv& csv) {
    const auto fits = [&](const Worksheet& each) {
        return csv.column({each.student}) != -1 && csv.column({each.grade, each.name}) != -1;
    };
    const auto found = std::ranges::find_if(worksheets, fits);
    return found == worksheets.end() ? nullptr : &*found;
}

/// The columns of the name: a heading, or several, "First Name + Last Name".
std::vector<int> name_columns(const Csv& csv, const std::string& heading) {
    if (const int column = csv.column({heading}); column != -1) return {column};
    std::vector<int> columns;
    for (std::size_t at = 0; at <= heading.size();) {
        const std::size_t end = std::min(heading.find('+', at), heading.size());
        columns.push_back(csv.wanted({trimmed(heading.substr(at, end - at))}));
        at = end + 1;
    }
    return columns;
}

/// A platform's gradebook also has rows of no student.
bool is_person(const Roster& roster, const Csv::Row& row) {
    if (!roster.of_canvas) return !(row.at(roster.student) + roster.name_in(row)).empty();
    return !trimmed(row.at(roster.student)).empty() &&
           lower_case(trimmed(row.at(0))) != "student, test";
}

/// The words before the number of most identifiers: "Participant " or "Teilnehmer/in"; nothing if
/// most have no number, or no words in common.
std::optional<std::string> common_words(const Roster& roster) {
    std::map<std::string, std::size_t> counts;
    std::size_t persons = 0;
    for (const Csv::Row& row : roster.csv.rows) {
        const std::string who = trimmed(row.at(roster.student));
        const std::string number = number_at_end(who);
        if (is_person(roster, row)) ++persons;
        if (!number.empty()) ++counts[who.substr(0, who.size() - number.size())];
    }
    for (const auto& [words, count] : counts)
        if (2 * count >= persons) return words;
    return std::nullopt;
}

class Finding {
public:
    Finding(Roster& roster, const StudentNames& names)
        : roster_(roster), names_(names), done_(roster.csv.rows.size()) {
        roster_.students.assign(done_.size(), "");
    }

    void find_all() {
        const std::optional<std::string> words = common_words(roster_);
        each_open_row([&](std::size_t i) { by_identifier(i, words); });
        std::map<std::string, int> rows_with;
        each_open_row([&](std::size_t i) { ++rows_with[folded(called(i))]; });
        each_open_row([&](std::size_t i) { by_name(i, rows_with[folded(called(i))]); });
        matched_ = taken_.size();
        each_open_row([&](std::size_t i) { without_submission(i); });
    }

    /// Number of rows that fit a submission.
    [[nodiscard]] std::size_t matched() const { return matched_; }

private:
    template <class Work>
    void each_open_row(Work work) {
        for (std::size_t i = 0; i < done_.size(); ++i) {
            if (done_[i] || !is_person(roster_, roster_.csv.rows[i])) continue;
            try {
                work(i);
            } catch (const InputError& error) {
                roster_.problems.push_back(error.what() + std::string("; it has no grade"));
                done_[i] = true;
            }
        }
    }

    [[nodiscard]] FileLocation place(std::size_t i) const {
        return {roster_.csv.file.filename().string(), roster_.csv.rows[i].line};
    }
    [[nodiscard]] std::string who(std::size_t i) const {
        return trimmed(roster_.csv.rows[i].at(roster_.student));
    }
    /// The name, or else the identifier.
    [[nodiscard]] std::string called(std::size_t i) const {
        const std::string name = roster_.name_in(roster_.csv.rows[i]);
        return name.empty() ? who(i) : name;
    }

    void set(std::size_t i, const std::string& student) {
        if (!taken_.insert(student).second)
            throw InputError(place(i),
                             "\"" + who(i) + "\" is " + student + ", who is listed already");
        roster_.students[i] = student;
        done_[i] = true;
    }

    void by_identifier(std::size_t i, const std::optional<std::string>& words) {
        if (who(i).empty()) return;
        const std::string number = number_at_end(who(i));
        Students matches = names_.named(who(i));
        if (matches.empty() && words && who(i) == *words + number) {
            matches = names_.numbered(number);
            has_numbers_ = has_numbers_ || !matches.empty();
        }
        if (const auto student = only(matches, who(i), place(i))) set(i, *student);
    }

    /// In a sheet with a platform's numbers, another number may be a namesake's, or a slip.
    void by_name(std::size_t i, int rows) {
        Students matches = names_.named(called(i));
        const bool by_bare_name = matches.empty();
        if (by_bare_name) matches = names_.unnumbered(called(i));
        for (const std::string& other : taken_) matches.erase(other);  // a namesake
        if (by_bare_name && !matches.empty() && has_numbers_ && !who(i).empty())
            throw InputError(place(i), "\"" + called(i) + "\" may be " + *matches.begin() +
                                           ", but \"" + who(i) + "\" is another number");
        if (!matches.empty() && rows > 1)
            throw InputError(place(i), "\"" + called(i) + "\" is the name of " +
                                           std::to_string(rows) + " lines, one of them " +
                                           *matches.begin() + ": write that in its column \"" +
                                           roster_.csv.head.at(roster_.student) + "\"");
        if (const auto student = only(matches, called(i), place(i))) set(i, *student);
    }

    void without_submission(std::size_t i) {
        const std::string number = number_at_end(who(i));
        std::string student = folded(called(i));
        if (called(i) != who(i) && !number.empty()) student += "_" + number;
        set(i, taken_.count(student) == 1 ? folded(who(i)) : student);
    }

    Roster& roster_;
    const StudentNames& names_;
    std::vector<bool> done_;
    Students taken_;
    bool has_numbers_ = false;
    std::size_t matched_ = 0;
};

}  // namespace

std::string Roster::name_in(const Csv::Row& row) const {
    return trimmed(joined(
        name, [&](int column) { return trimmed(row.at(column)); }, " "));
}

bool Roster::is_maximum_row(const Csv::Row& row) const {
    if (!of_canvas || !trimmed(row.at(student)).empty()) return false;
    return lower_case(trimmed(row.at(0))).starts_with("points possible") ||
           std::ranges::any_of(row.cells,
                               [](const std::string& each) { return number_of(each).has_value(); });
}

std::optional<double> Roster::maximum_of(const Csv::Row& row) const {
    std::optional<double> most;
    if (!of_canvas || maximum != -1) {
        most = number_of(row.at(maximum));
    } else {
        const auto found = std::ranges::find_if(
            csv.rows, [this](const Csv::Row& each) { return is_maximum_row(each); });
        if (found != csv.rows.end()) most = number_of(found->at(grade));
    }
    return most && *most > 0 ? most : std::nullopt;
}

Roster roster_of(Csv csv, const Headings& headings) {
    const bool of_canvas = csv.column({"SIS Login ID", "SIS User ID"}) != -1 ||
                           (csv.column({"ID"}) != -1 && csv.column({"Section"}) != -1);
    const Worksheet* moodle = of_canvas ? nullptr : worksheet_of(csv);
    Roster roster{.csv = std::move(csv), .of_canvas = of_canvas};
    const auto heading = [&](const char* setting, const std::string& otherwise) {
        const auto found = headings.find(setting);
        return found == headings.end() ? otherwise : found->second;
    };
    const auto column = [&](const char* setting, const char* otherwise) {
        const auto found = headings.find(setting);
        return found != headings.end() ? roster.csv.wanted({found->second})
                                       : roster.csv.column({otherwise});
    };
    const std::string by = heading("student", moodle ? moodle->student : of_canvas ? "ID" : "");
    roster.student = roster.csv.wanted(by.empty() ? std::vector<std::string>{"student", "name"}
                                                  : std::vector{by});
    if (headings.count("name") == 1)
        roster.name = name_columns(roster.csv, headings.at("name"));
    else if (const int name = roster.csv.column({of_canvas ? "Student" : "Full name", "Nom complet",
                                                 "Vollständiger Name", "Nombre completo", "Name"});
             name != -1)
        roster.name = {name};
    roster.grade_title = heading("grade", moodle ? moodle->grade : "Raysteps");
    roster.grade = roster.csv.column({roster.grade_title});
    roster.maximum = column("maximum", moodle ? moodle->maximum : "");
    roster.comment = column("comment", moodle ? moodle->comment : "");
    roster.group = column("group", "");
    return roster;
}

void find_students(Roster& roster, const StudentNames& names, const Students& submitted) {
    Finding finding(roster, names);
    finding.find_all();
    const auto is_of_group = [&](const Csv::Row& row) {
        return roster.group != -1 && !names.named(row.at(roster.group)).empty();
    };
    const auto& rows = roster.csv.rows;
    if (submitted.empty() || finding.matched() > 0 || std::ranges::any_of(rows, is_of_group))
        return;
    const InputError error({roster.csv.file.string()},
                           "no line of it is one of the submissions, such as " +
                               *submitted.begin() + ": its students are taken from column \"" +
                               roster.csv.head.at(roster.student) +
                               "\"; \"student:\" and \"name:\" in term.txt name others of " +
                               enumerated(roster.csv.head.cells));
    throw roster.problems.empty() ? error : error.with(roster.problems.front());
}

std::optional<double> number_of(std::string text) {
    text = trimmed(text);
    std::ranges::replace(text, ',', '.');
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace rt::grade
