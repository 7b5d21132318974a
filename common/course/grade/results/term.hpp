// A lecturer's settings for a class: the file term.txt in the results.
// docs/reference/instructors.md has an example.
#pragma once

#include "common/course/grade/reports/csv.hpp"
#include "common/course/grade/results/results.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rt::grade {

/// Points that the lecturer sets.
struct Override {
    double points = 0;
    std::string comment;
};

/// The platform's own list of a class, and the meaning of its columns.
struct Roster {
    Csv csv;
    int student = 0;                    ///< the column that identifies a student
    int name = -1;                      ///< the column of full names, or -1
    std::string grade;                  ///< the heading of the column for the grade
    std::string comment;                ///< the heading of the column for remarks, or empty
    std::vector<std::string> students;  ///< by row: the names in the results
};

struct Term {
    static constexpr int total = 0;  ///< the key of the total among the stages of overrides

    std::optional<Roster> roster;
    std::map<int, double> weights;  ///< by stage; 1 if not listed
    std::map<int, bool> bonus;      ///< stages whose points are a bonus
    double late_percent = 0;        ///< of the points, per day
    std::map<std::string, double> days_late;
    std::map<std::pair<std::string, int>, Override> overrides;
    double out_of = 0;       ///< the uploaded totals are scaled to this maximum; 0 for no scaling
    bool anonymous = false;  ///< public reports have numbers instead of names
    std::uint64_t key = 0;   ///< the key of these numbers
    std::vector<std::string> notes;  ///< on lines of these files that fit no student or no stage

    [[nodiscard]] double weight(int stage) const;
    /// "s-3f07a2c1" if anonymous; else the student's name.
    [[nodiscard]] std::string called(const std::string& student) const;
};

/// Reads results/term.txt and the files that it names; returns a term without settings if it does
/// not exist. A student is identified by the name in the results, or by the number or name on the
/// roster. Throws InputError.
[[nodiscard]] Term read_term(const std::filesystem::path& results, const std::vector<Mark>& marks);

/// Writes results/upload.csv, the roster with grades in the platform's import format, if the term
/// has a roster, and results/names.csv if the term is anonymous. Removes a file of an earlier run
/// that the term no longer requires. Throws InputError.
void write_upload(const std::filesystem::path& results, const std::vector<Mark>& marks,
                  const Term& term);

}  // namespace rt::grade
