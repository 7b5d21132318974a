// The feedback page of each student.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/term.hpp"

namespace rt::grade {

/// Writes results/students/<student>/feedback.html for each student with a submission: one file
/// that contains its pictures. Throws InputError.
void write_feedback(const std::filesystem::path& results, const std::vector<Mark>& marks,
                    const Term& term = {});

}  // namespace rt::grade
