// The pixels that shapes narrower than a pixel, and gaps between shapes, may cover in part, known
// from the scene before any ray is traced.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/trial.hpp"

namespace rt {

/// The fine shapes and gaps of the scene, seen from its camera. Those that another shape hides
/// count as well; shadows and reflections of them do not.
[[nodiscard]] FineShapes fine_shapes(const Scene& scene);

}  // namespace rt
