// `./course debug`: a debugger at the call that fails.
#pragma once

#include <string>

namespace rt {

/// Builds the suite with the student's files compiled for a debugger, and starts gdb or lldb at the
/// last call of a student's function before the first failure of a case: of the one whose name
/// contains the words, or if there are none, of the first that failed in the last check. Throws
/// InputError without a debugger, such a case or a failure. Returns the debugger's exit status.
/// Unless it `starts` one, it only prepares the program, for an editor (.vscode/launch.json).
int debug(int stage, const std::string& words, bool starts);

}  // namespace rt
