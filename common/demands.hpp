// What the trials of `--tolerance` and `--time` need to know of a scene, and how they ask it.
#pragma once

#include "common/scene.hpp"
#include "common/trials.hpp"

namespace rt {

/// Of the picture that a stage makes of the scene.
[[nodiscard]] Demands demands_of(const Scene& scene, int stage, const Look& look);

/// As Trials::shot.
[[nodiscard]] Shot shot_of(const Scene& scene, const Look& look, const ShotSettings& settings);

}  // namespace rt
