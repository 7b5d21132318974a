// Reflections in mirrors, from this stage on.
#pragma once

#include "common/context.hpp"
#include "common/ray.hpp"
#include "common/scene.hpp"
#include "common/surface.hpp"

namespace rt {

/// The color along the ray that the surface reflects; black if there have been enough reflections.
[[nodiscard]] Color reflection(const Scene& scene, const Ray& ray, const Surface& surface,
                               Context& context);

}  // namespace rt
