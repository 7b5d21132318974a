// What a wrong answer looks like: a known mistake, or else the smallest question that shows it.
#pragma once

namespace rt {

/// Asks the student's file of the stage the questions of tests/mistakes/<stage>/probes.txt. Says
/// the sentence of the known mistake that answers alike; if none does, the plainest question that
/// is answered wrong, drawn in renders/ if it can be. Says nothing if nothing is found.
void show_diagnosis(int stage);

}  // namespace rt
