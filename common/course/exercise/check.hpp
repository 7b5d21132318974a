// `./course check`: a verdict on the student's file of a stage.
#pragma once

namespace rt {

/// Builds the student's file of the stage and tests it with the references of all other stages, in
/// both precisions. Prints one screen: how many cases pass, the most telling failure, and where the
/// picture is beside the reference's; with `complete` everything. Returns 0 if all cases pass, else
/// 1.
int check(int stage, bool complete = false);

}  // namespace rt
