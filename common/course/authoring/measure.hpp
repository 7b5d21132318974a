// `./course measure`: the whole study of speed against accuracy, on this machine.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// Runs the studies with these names, or all, and writes docs/accuracy/*.csv, the plots beside them
/// and the tables of docs/reference/accuracy.md. Throws InputError for an unknown name, and without
/// Boost or matplotlib; ProgramError if something fails.
int measure(const std::vector<std::string>& names);

}  // namespace rt
