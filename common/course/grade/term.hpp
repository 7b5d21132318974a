// What a lecturer settles for a class, beside what is graded: the file term.txt in the results.
// docs/instructors.md has an example.
#pragma once

#include "common/course/grade/csv.hpp"
#include "common/course/grade/results.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rt::grade {

/// Points that a lecturer gave.
struct Override {
    double points = 0;
    std::string comment;
};

/// The platform's own list of a class, and which of its columns are what.
struct Roster {
    Csv csv;
    int student = 0;                    ///< the column by which a student is known
    int name = -1;                      ///< the column of full names, if there is one
    std::string grade;                  ///< the heading of the column that is filled
    std::string comment;                ///< the same, for remarks; or nothing
    std::vector<std::string> students;  ///< by row: as the results call them
};

struct Term {
    static constexpr int total = 0;  ///< among the stages of overrides

    std::optional<Roster> roster;
    std::map<int, double> weights;  ///< by stage; 1 if there is none
    std::map<int, bool> bonus;      ///< stages that count, but are not asked for
    double late_percent = 0;        ///< of the points, a day
    std::map<std::string, double> days_late;
    std::map<std::pair<std::string, int>, Override> overrides;
    double out_of = 0;  ///< to which the totals that are uploaded are scaled; 0 if they are not
    bool anonymous = false;            ///< students are called by numbers in what may be shown
    std::uint64_t key = 0;             ///< of these numbers
    std::vector<std::string> unknown;  ///< names in these files that are nobody's

    [[nodiscard]] double weight(int stage) const;
    /// "s-3f07a2c1" if anonymous; else as the student is called.
    [[nodiscard]] std::string called(const std::string& student) const;
};

/// Reads results/term.txt and the files that it names; without it a term of no settings. A student
/// is named as in the results, or by his number or name on the roster. Throws InputError.
[[nodiscard]] Term read_term(const std::filesystem::path& results, const std::vector<Mark>& marks);

/// Writes results/upload.csv, the roster with grades, as the platform imports it, and, if the term
/// is anonymous, results/names.csv. Throws InputError.
void write_upload(const std::filesystem::path& results, const std::vector<Mark>& marks,
                  const Term& term);

}  // namespace rt::grade
