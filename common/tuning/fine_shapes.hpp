// The pixels that shapes narrower than a pixel may cover in part, known from the scene before any
// ray is traced.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/trial.hpp"

namespace rt {

/// The fine shapes of the scene, seen from its camera. Shapes that another one hides count as well;
/// their shadows and their reflections do not.
[[nodiscard]] FineShapes fine_shapes(const Scene& scene);

}  // namespace rt
