// Reflections in mirrors, from this stage on.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/render/context.hpp"
#include "common/render/surface.hpp"
#include "common/scene/scene.hpp"

namespace rt {

/// The color along the ray that the surface reflects; black if there have been enough reflections.
[[nodiscard]] Color reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
                               Context& context);

}  // namespace rt
