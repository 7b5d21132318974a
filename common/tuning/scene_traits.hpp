// Scene traits and pixel samples for `--tolerance` and `--time`.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/trial.hpp"

namespace rt {

/// The traits of the scene that matter for the given stage's picture.
[[nodiscard]] Demands demands_of(const Scene& scene, int stage, const Look& look);

/// Renders sample pixels of the scene, as Trials::shot describes.
[[nodiscard]] Shot shot_of(const Scene& scene, const Look& look, const ShotSettings& settings);

}  // namespace rt
