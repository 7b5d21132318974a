// The class report, for the instructor.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/term.hpp"

namespace rt::grade {

/// Writes results/class.html: every stage of every student, changes by the term's rules, the known
/// mistakes, the hardest cases, the students whose code was stopped, and similar files (apart from
/// the starters in the project's folder). The edition is the date and the version on the page.
/// Throws InputError.
void write_class_report(const std::filesystem::path& results, const std::filesystem::path& project,
                        const std::vector<Mark>& marks, const Term& term = {},
                        const std::string& edition = "");

}  // namespace rt::grade
