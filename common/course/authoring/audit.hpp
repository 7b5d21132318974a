// `./course audit`: a completeness check of every stage.
#pragma once

namespace rt {

/// Checks each stage: its reference passes, its starter compiles and fails the listed cases, and
/// its hints, page, scene, picture, figures, known mistakes and other right answers exist. Prints
/// one line per stage, and one per missing thing. Returns 0 if nothing is missing, else 1.
int audit();

}  // namespace rt
