// What an instructor sees of a class.
#pragma once

#include "common/course/grade/results.hpp"
#include "common/course/grade/term.hpp"

namespace rt::grade {

/// Writes results/class.html: every stage of every student, what the term has changed, the known
/// mistakes, the hardest cases, whose code was stopped, and files that are alike, beyond what they
/// have of the starters in the project's folder. The edition says of when and of what it is. Throws
/// InputError.
void write_class_report(const std::filesystem::path& results, const std::filesystem::path& project,
                        const std::vector<Mark>& marks, const Term& term = {},
                        const std::string& edition = "");

}  // namespace rt::grade
