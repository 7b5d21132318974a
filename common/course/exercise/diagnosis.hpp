// The diagnosis of a wrong answer: a known mistake, or else the smallest input that shows the
// error.
#pragma once

namespace rt {

/// Runs the student's file of the stage on the inputs in tests/mistakes/<stage>/probes.txt. Prints
/// the sentence of the known mistake with the same answers; if no mistake matches, the simplest
/// input with a wrong answer, drawn in renders/ if possible. Prints nothing if no answer is wrong.
void show_diagnosis(int stage);

}  // namespace rt
