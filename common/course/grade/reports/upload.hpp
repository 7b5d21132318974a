// The grades for a learning platform.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/term.hpp"

#include <string>

namespace rt::grade {

/// Writes results/upload.csv, the roster with grades in the platform's import format, if the term
/// has a roster, and results/names.csv if the term is anonymous. Removes a file of an earlier run
/// that the term no longer requires. Returns a sentence on the grades in upload.csv, or nothing
/// without it. Throws InputError.
std::string write_upload(const std::filesystem::path& results, const std::vector<Mark>& marks,
                         const Term& term);

}  // namespace rt::grade
