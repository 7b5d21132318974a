// The grade book: a line a student, for any spreadsheet.
#pragma once

#include "common/course/grade/results.hpp"
#include "common/course/grade/term.hpp"

namespace rt::grade {

/// Writes results/grades.csv: student, the points of each stage, total, of, and what the term has
/// to remark on a student. Throws InputError.
void write_grade_book(const std::filesystem::path& results, const std::vector<Mark>& marks,
                      const Term& term = {});

}  // namespace rt::grade
