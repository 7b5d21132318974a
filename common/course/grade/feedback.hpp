// What a student reads of his marks.
#pragma once

#include "common/course/grade/results.hpp"

namespace rt::grade {

/// Writes results/students/<student>/feedback.html for each student. Throws InputError.
void write_feedback(const std::filesystem::path& results, const std::vector<Mark>& marks);

}  // namespace rt::grade
