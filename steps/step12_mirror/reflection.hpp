// What is seen in a mirror, from here on.
#pragma once

#include "common/context.hpp"
#include "common/ray.hpp"
#include "common/scene.hpp"
#include "common/surface.hpp"

namespace rt {

/// The colour along the ray that the surface sends on; black, if there have been enough.
[[nodiscard]] Color reflection(const Scene& scene, const Ray& ray, const Surface& surface,
                               Context& context);

}  // namespace rt
