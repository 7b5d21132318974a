// A stage's picture, compared with the one its page shows.
#pragma once

#include "tests/kit/verdict.hpp"

#include "common/image/image.hpp"
#include "common/render/render_settings.hpp"

#include <string>

namespace rt {

/// A file of the project, named from its top: "scenes/cornell_box.rt".
[[nodiscard]] std::string project_file(const std::string& name);

/// "255, 0, 128"
[[nodiscard]] std::string text(Rgb color);

/// The settings of a rendering, and its fraction of pixels.
struct Drawing {
    std::string scene;  ///< if it is not called as the picture
    RenderSettings settings;
    int every = 3;  ///< only every `every`-th pixel and row
};

/// True if a pixel's color is as near to the reference's as right answers are, by the spread in the
/// picture of the same name in tests/programs/pictures.
[[nodiscard]] bool fits(Rgb got, Rgb reference, Rgb spread);

/// Renders scenes/<name>.rt, in the size of docs/pictures/<name>.png, and compares.
///
/// Each pixel may differ by as much as right answers do: by the spread in
/// tests/programs/pictures/<name>.png (of renderings with jittered rays, in both precisions), and
/// by 1 of 255 for rounding. Where the spread is large, beside an edge, the pixel is not tested.
[[nodiscard]] Verdict picture_matches(const std::string& name, const Drawing& drawing = {});

}  // namespace rt
