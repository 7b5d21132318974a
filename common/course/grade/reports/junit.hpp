// A report in JUnit's XML.
#pragma once

#include "common/course/grade/results/results.hpp"

namespace rt::grade {

/// Writes results/junit.xml: one testsuite per student and stage. Throws InputError.
void write_junit(const std::filesystem::path& results, const std::vector<Mark>& marks);

}  // namespace rt::grade
