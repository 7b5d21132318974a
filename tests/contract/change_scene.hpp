// The change of a scene of one pixel, and of the color that `trace` returns for it; and that of a
// picture without shapes.
#pragma once

#include "common/image/image.hpp"
#include "common/math/real.hpp"
#include "common/render/render_settings.hpp"

#include "tests/contract/change.hpp"

namespace rt::contract {

/// The whole scene, with its camera, transformed: with a sky around the vertical alone, and with
/// --shade normal to other axes. The channels of its light, of its sky and, without any light, of
/// its shapes' colors are exchanged, and each dimmed by a factor of its own.
[[nodiscard]] Scene changed(const Scene& scene, const RenderSettings& settings,
                            const Change& change);

/// The color for the scene, from that for the changed scene.
[[nodiscard]] Color changed_back(Color color, const Scene& scene, const RenderSettings& settings,
                                 const Change& change);

/// The scene of a larger picture, whose middle is that of the scene. With shapes the scene itself:
/// there, random numbers of a pixel depend on its place in the picture.
[[nodiscard]] Scene enlarged(const Scene& scene, const Change& change);

/// The scene's picture, from that of the enlarged scene.
[[nodiscard]] Image middle_of(const Image& picture, Resolution size);

}  // namespace rt::contract
