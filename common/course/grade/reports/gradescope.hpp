// Results for Gradescope, which shows a student the contents of the autograder's results.json:
// https://gradescope-autograders.readthedocs.io/en/latest/specs/
#pragma once

#include "common/course/grade/results/results.hpp"

namespace rt::grade {

/// Throws InputError if the file exists and is neither empty nor a results.json, which a new one
/// may replace.
void check_gradescope_file(const std::filesystem::path& file);

/// Writes results.json from the marks of one student. Throws InputError.
void write_gradescope(const std::filesystem::path& file, const std::vector<Mark>& marks);

}  // namespace rt::grade
