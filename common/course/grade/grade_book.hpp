// The grade book: a line a student, for any spreadsheet.
#pragma once

#include "common/course/grade/results.hpp"

namespace rt::grade {

/// Writes results/grades.csv: student, the points of each stage, total, of. Throws InputError.
void write_grade_book(const std::filesystem::path& results, const std::vector<Mark>& marks);

/// A cell of RFC 4180, which no spreadsheet takes for a formula.
[[nodiscard]] std::string cell(const std::string& text);

}  // namespace rt::grade
