// A stage's picture, compared with the one its page shows.
#pragma once

#include "tests/kit/verdict.hpp"

namespace rt {

/// A file of the project, named from its top: "scenes/cornell_box.rt".
[[nodiscard]] std::string project_file(const std::string& name);

/// Renders scenes/<name>.rt, in the size of docs/pictures/<name>.png, and compares.
///
/// A pixel of the picture may differ by 1 of 255: a colour near n + ½ rounds either way. Beside an
/// edge, rounding in the last digit decides which surface a pixel's ray meets, so a pixel whose
/// neighbours in the reference differ may take any value among them.
///
/// Of a picture that takes seconds, every so many-th pixel of every so many-th row is enough.
[[nodiscard]] Verdict picture_matches(const std::string& name, int every = 1);

}  // namespace rt
