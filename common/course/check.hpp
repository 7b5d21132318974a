// `./course check`: what is right, and what is wrong first.
#pragma once

namespace rt {

/// Builds the student's file of the stage and judges it on the references of all others, in both
/// precisions. Says what passes, explains the first failure, shows the picture beside the
/// reference's. Returns 0 if all is right, else 1.
int check(int stage);

/// Checks, and again whenever a file of the stage is saved, until Ctrl-C.
[[noreturn]] void watch(int stage);

}  // namespace rt
