// Trials on single pixels of a scene, for `--tolerance` and `--time`.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/trial.hpp"

namespace rt {

/// Renders sample pixels of the scene, as Trials::render_pixels describes.
[[nodiscard]] TrialSample render_pixels(const Scene& scene, const RenderSettings& settings,
                                        const TrialRequest& request);

/// Traces rays through pixels of the scene, as Trials::trace_histories describes.
[[nodiscard]] TrialHistories trace_histories(const Scene& scene, const RenderSettings& settings,
                                             const TrialRequest& request);

}  // namespace rt
