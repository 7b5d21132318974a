// The way of the camera with `--turn`: around the middle of the scene.
#pragma once

#include "common/scene/scene.hpp"

#include <optional>

namespace rt {
inline namespace RT_PRECISION {

/// The middle of the box around all shapes except planes; nothing if there are none.
[[nodiscard]] std::optional<Vec3> middle_of_shapes(const Scene& scene);

/// The camera after a share, 0 to 1, of its way around a vertical axis through the middle,
/// counterclockwise from above. It turns with its way, so that the middle keeps its place in the
/// picture.
[[nodiscard]] Camera turned(Camera camera, Vec3 middle, Real share);

}  // namespace RT_PRECISION
}  // namespace rt
