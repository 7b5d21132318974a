// The place that a scene takes.
#pragma once

#include "common/scene/scene.hpp"

namespace rt {

/// The bounding box of all shapes except planes; empty if there are none.
[[nodiscard]] inline BoundingBox box_of_shapes(const Scene& scene) {
    BoundingBox all;
    for_each_kind(scene, [&all](const auto& primitives) { all = merged(all, primitives.box()); });
    return merged(all, scene.meshes.box());
}

}  // namespace rt
