// The diagnosis of a wrong answer: a known mistake, or else the smallest input that shows the
// error.
#pragma once

#include <filesystem>

namespace rt {

/// Runs the student's file of the stage on the inputs in tests/mistakes/<stage>/probes.txt. Prints
/// the sentence of the known mistake with the same answers and the same failing cases, by the
/// report of the suite; if no mistake matches, the simplest input with a wrong answer, drawn in
/// renders/ if possible. Prints nothing if no answer is wrong.
void show_diagnosis(int stage, const std::filesystem::path& report);

}  // namespace rt
