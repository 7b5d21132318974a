// `./course audit`: whether every stage is whole.
#pragma once

namespace rt {

/// Looks at each stage: its reference passes, its starter compiles and fails the cases it should,
/// and its hints, page, scene, picture, figures, known mistakes and other right answers are there.
/// One line a stage, and one for each thing that is missing. Returns 0 if none is, else 1.
int audit();

}  // namespace rt
