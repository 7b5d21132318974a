// The traits of a scene, and trials on single pixels, in one precision, for `--tolerance` and
// `--time`.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/trial.hpp"

namespace rt {

/// The traits of the scene that matter for the given stage's picture.
[[nodiscard]] SceneTraits scene_traits(const Scene& scene, int stage,
                                       const RenderSettings& settings);

/// The pixels that shapes narrower than a pixel, and gaps between shapes, may cover in part, seen
/// from the scene's camera, before any ray is traced. Those that another shape hides count as well;
/// shadows and reflections of them do not.
[[nodiscard]] FineShapes fine_shapes(const Scene& scene);

/// Renders sample pixels of the scene, as Trials::render_pixels describes.
[[nodiscard]] TrialSample render_pixels(const Scene& scene, const RenderSettings& settings,
                                        const TrialRequest& request);

/// Traces rays through pixels of the scene, as Trials::trace_histories describes.
[[nodiscard]] TrialHistories trace_histories(const Scene& scene, const RenderSettings& settings,
                                             const TrialRequest& request);

}  // namespace rt
