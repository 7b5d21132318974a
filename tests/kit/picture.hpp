// A stage's picture, compared with the one its page shows.
#pragma once

#include "tests/kit/verdict.hpp"

#include "common/image.hpp"
#include "common/look.hpp"

namespace rt {

/// A file of the project, named from its top: "scenes/cornell_box.rt".
[[nodiscard]] std::string project_file(const std::string& name);

/// How a picture is drawn, and how much of it.
struct Drawing {
    std::string scene;  ///< if it is not called as the picture
    Look look;
    int every = 1;  ///< of a picture that takes seconds, so many-th pixels and rows are enough
};

/// Whether a pixel's colour is as near to the reference's as right answers are, by what the picture
/// of the same name in tests/pictures says of it.
[[nodiscard]] bool fits(Rgb came, Rgb reference, Rgb spread);

/// Renders scenes/<name>.rt, in the size of docs/pictures/<name>.png, and compares.
///
/// Each pixel may be off by as much as right answers are: by what tests/pictures/<name>.png says of
/// it (the spread of drawings whose rays were jittered, in both precisions), and by 1 of 255 for
/// rounding. Where that is much, beside an edge, the pixel is not judged.
[[nodiscard]] Verdict picture_matches(const std::string& name, const Drawing& drawing = {});

}  // namespace rt
