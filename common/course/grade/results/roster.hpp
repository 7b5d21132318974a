// The list of a class: a platform's export, or a spreadsheet of the lecturer's own.
#pragma once

#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/student_names.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// The headings that the settings name, by setting: student, name, grade, maximum, comment, group.
using Headings = std::map<std::string, std::string>;

/// The list, and the meaning of its columns; -1 for a column that it does not have.
struct Roster {
    Csv csv;
    bool of_canvas = false;
    int student = 0;        ///< the column that identifies a student
    std::vector<int> name;  ///< the columns of the name: one, or first and last
    int grade = -1;         ///< the column that the upload fills
    int maximum = -1;       ///< of the grade
    int comment = -1;
    int group = -1;
    std::string grade_title;  ///< the heading of the grade's column, which may be a new one
    std::vector<std::string> students;  ///< by row: the names in the results; empty for no student
    std::vector<std::string> problems;  ///< on rows: "sheet.csv:3: error: …"

    /// The name in the row, "Zoe Doe".
    [[nodiscard]] std::string name_in(const Csv::Row& row) const;
    /// The row of Canvas's gradebook that has the points possible instead of a student.
    [[nodiscard]] bool is_maximum_row(const Csv::Row& row) const;
    /// The maximum of the grade in this row; nothing if the sheet has none.
    [[nodiscard]] std::optional<double> maximum_of(const Csv::Row& row) const;
};

/// The columns of a sheet: those that the settings name, or else those of Moodle (in English,
/// French, German and Spanish), of Canvas, or "student" and "name". Throws InputError if a column
/// is missing.
[[nodiscard]] Roster roster_of(Csv csv, const Headings& headings);

/// Finds the student of each row among those with a submission. A row that fits several, or one
/// that another row has, is a problem of its own, and has no student. Throws InputError if no row
/// fits a submission.
void find_students(Roster& roster, const StudentNames& names, const Students& submitted);

/// "7,5" too, as some spreadsheets write it; nothing for other text.
[[nodiscard]] std::optional<double> number_of(std::string text);

}  // namespace rt::grade
