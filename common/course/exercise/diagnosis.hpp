// The diagnosis of a wrong answer: a known mistake, or else the smallest input that shows the
// error.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace rt {

/// Runs the student's file of the stage on the inputs in tests/mistakes/<stage>/probes.txt. Prints
/// the sentences of the known mistakes that give the wrong answers, by these and by the report of
/// the suite; if no mistake does, the simplest input with a wrong answer, drawn in
/// renders/ if possible. Prints nothing if no answer is wrong.
/// The functions named in `unwritten` are left out.
void show_diagnosis(int stage, const std::filesystem::path& report,
                    const std::set<std::string>& unwritten);

}  // namespace rt
