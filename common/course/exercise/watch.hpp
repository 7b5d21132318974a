// `./course watch`: a check whenever a file is saved.
#pragma once

namespace rt {

/// Checks the stage, and again whenever a file of it is saved, until Ctrl-C. On a terminal, each
/// check has a screen of its own, and keys: r checks again, h shows a hint, n goes on to the next
/// stage once this one passes, l lists the stages, q ends.
void watch(int stage);

}  // namespace rt
