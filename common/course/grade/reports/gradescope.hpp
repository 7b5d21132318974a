// Results for Gradescope, which shows a student the contents of the autograder's results.json:
// https://gradescope-autograders.readthedocs.io/en/latest/specs/
#pragma once

#include "common/course/grade/results/results.hpp"

namespace rt::grade {

/// Writes results.json from the marks of one student. Throws InputError.
void write_gradescope(const std::filesystem::path& file, const std::vector<Mark>& marks);

}  // namespace rt::grade
