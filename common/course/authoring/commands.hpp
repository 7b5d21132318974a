// The commands of `./course` for authors.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// Checks each stage, or only one: its reference passes, its starter compiles and fails the listed
/// cases, and its hints, page, scene, picture, figures, known mistakes and other right answers
/// exist. Prints one line per stage, and one per missing thing. Returns 0 if nothing is missing,
/// else 1.
int audit(std::optional<int> only);

/// Runs the studies with these names, or all, and writes docs/accuracy/*.csv, the plots beside them
/// and the tables of docs/reference/accuracy.md. Throws InputError for an unknown name, and without
/// Boost or matplotlib; ProgramError if something fails.
int measure(const std::vector<std::string>& names);

}  // namespace rt
