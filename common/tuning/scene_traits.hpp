// Scene traits and pixel samples for `--tolerance` and `--time`.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/trial.hpp"

namespace rt {

/// The traits of the scene that matter for the given stage's picture.
[[nodiscard]] SceneTraits scene_traits(const Scene& scene, int stage,
                                       const RenderSettings& settings);

/// Renders sample pixels of the scene, as Trials::shot describes.
[[nodiscard]] PixelSample shot_of(const Scene& scene, const RenderSettings& settings,
                                  const SampleRequest& request);

}  // namespace rt
