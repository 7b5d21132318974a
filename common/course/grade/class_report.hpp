// What an instructor sees of a class.
#pragma once

#include "common/course/grade/results.hpp"

namespace rt::grade {

/// Writes results/class.html: every stage of every student, the known mistakes, the hardest cases,
/// and files that are alike, beyond what they have of the starters in the project's folder. Throws
/// InputError.
void write_class_report(const std::filesystem::path& results, const std::filesystem::path& project,
                        const std::vector<Mark>& marks);

}  // namespace rt::grade
