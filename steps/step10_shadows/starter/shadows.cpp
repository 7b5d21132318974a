// Stage 10, to be written: docs/step10_shadows.md.
#include "steps/step10_shadows/shadows.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const Surface& surface, Vec3 light) {
    // From off the surface, by surface.error on surface.side, to a little before the light.
    RT_TODO(surface, light);
    return {.ray = {.origin = surface.point, .direction = surface.side},
            .interval = {.min = 0, .max = 0}};  // empty: nothing throws a shadow
}

}  // namespace rt
