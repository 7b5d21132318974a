// The traits of a scene, for `--tolerance` and `--time`.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/trial.hpp"

namespace rt {

/// The traits of the scene that matter for the given stage's picture.
[[nodiscard]] SceneTraits scene_traits(const Scene& scene, int stage,
                                       const RenderSettings& settings);

}  // namespace rt
