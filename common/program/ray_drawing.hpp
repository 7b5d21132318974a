// A drawing in three dimensions: the outlines of a scene, and the rays of one pixel (--rays).
#pragma once

#include "common/image/pixel.hpp"
#include "common/render/render_settings.hpp"
#include "common/scene/scene.hpp"

#include <string>

namespace rt {

/// Returns the drawing as one line of JSON, for the page of `./course view`. Numbers in texts are
/// those of `--pixel`.
[[nodiscard]] std::string ray_drawing(const Scene& scene, const RenderSettings& settings,
                                      Pixel pixel);

}  // namespace rt
