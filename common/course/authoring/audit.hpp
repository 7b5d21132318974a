// `./course audit`: a completeness check of the stages.
#pragma once

#include <optional>

namespace rt {

/// Checks each stage, or only one: its reference passes, its starter compiles and fails the listed
/// cases, and its hints, page, scene, picture, figures, known mistakes and other right answers
/// exist. Prints one line per stage, and one per missing thing. Returns 0 if nothing is missing,
/// else 1.
int audit(std::optional<int> only);

}  // namespace rt
