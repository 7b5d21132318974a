// Pictures, as the stage's program draws them, and single colors.
#pragma once

#include "common/image/image.hpp"
#include "common/math/real.hpp"
#include "common/render/render_settings.hpp"
#include "common/scene/scene.hpp"

namespace rt {

/// The scene rendered through its first camera. For a slow picture, only every `every`-th pixel of
/// every `every`-th row; the others are black. If the suite uses another process (common/contract),
/// the picture is rendered there.
[[nodiscard]] Image rendered(const Scene& scene, const RenderSettings& settings = {},
                             int every = 1);

/// The color that `trace` returns for the first pixel of the first camera, in the same process as
/// `rendered`.
[[nodiscard]] Color traced(const Scene& scene, const RenderSettings& settings);

}  // namespace rt
