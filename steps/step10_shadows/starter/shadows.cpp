// Stage 10, to be written. docs/step10_shadows.md explains it, the header is its contract.
// Until it is written, there are no shadows.
// `./course check 10` reports errors, `./course hint 10` prints the next hint.
#include "steps/step10_shadows/shadows.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include <algorithm>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    // From a point off the surface, by surface.error along surface.geometric_normal, to a little
    // before the light.
    RT_TODO(surface, light);
    return {.ray = {.origin = surface.point, .direction = surface.geometric_normal},
            .interval = {.min = 0, .max = 0}};  // empty: no shadows
}

}  // namespace rt
