// An explanation for a picture of a single color, with a remedy.
#pragma once

#include "common/image/image.hpp"
#include "common/render/render_settings.hpp"
#include "common/scene/scene.hpp"

#include <string>

namespace rt {

/// Returns one sentence if all pixels of the stage's picture have one color, else an empty string.
/// The remedy that it suggests has been tried with a few rays. The picture is that of the scene's
/// first camera. Empty too if a function that is not written yet was called: that is the reason.
[[nodiscard]] std::string why_blank(const Scene& scene, const RenderSettings& settings, int stage,
                                    const Image& image);

}  // namespace rt
