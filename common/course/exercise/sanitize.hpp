// `./course check --sanitize`: the sanitizers' report.
#pragma once

namespace rt {

/// Runs the suites with the student's files compiled with AddressSanitizer and
/// UndefinedBehaviorSanitizer, and prints the first error that these find. Returns 0 if there is
/// none, else 1.
int check_with_sanitizers(int stage);

}  // namespace rt
