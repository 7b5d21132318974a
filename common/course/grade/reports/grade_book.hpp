// The grade book for spreadsheets: one line per student.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/term.hpp"

namespace rt::grade {

/// Writes results/grades.csv: student, the points of each stage, total, maximum, and the term's
/// remarks on the student. Throws InputError.
void write_grade_book(const std::filesystem::path& results, const std::vector<Mark>& marks,
                      const Term& term = {});

}  // namespace rt::grade
