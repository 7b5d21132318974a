// Stage 10, to be written: docs/step10_shadows.md says how, the header what is promised.
// Until it is written, nothing throws a shadow.
// `./course check 10` says what is wrong, `./course hint 10` what to think of next.
#include "steps/step10_shadows/shadows.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

#include <algorithm>

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

ShadowRay shadow_ray(const Surface& surface, Vec3 light) {
    // From off the surface, by surface.error on surface.side, to a little before the light.
    RT_TODO(surface, light);
    return {.ray = {.origin = surface.point, .direction = surface.side},
            .interval = {.min = 0, .max = 0}};  // empty: nothing throws a shadow
}

}  // namespace rt
