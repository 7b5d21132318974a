// `./course check`: the passing cases, and the first failing one.
#pragma once

namespace rt {

/// Builds the student's file of the stage and tests it with the references of all other stages, in
/// both precisions. Prints how many cases pass, explains the first failure, and shows the picture
/// beside the reference's. Returns 0 if all cases pass, else 1.
int check(int stage);

/// Runs the check, and repeats it whenever a file of the stage is saved, until Ctrl-C.
[[noreturn]] void watch(int stage);

}  // namespace rt
