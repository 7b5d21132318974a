// Stage 11, to be written: docs/step11_soft_shadows.md says how, the header what is promised.
// Begin with light_point. Until lit_share is written all of a light arrives, and shadows stay away;
// share_error counts only with --tolerance.
// `./course check 11` says what is wrong, `./course hint 11` what to think of next.
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

Vec3 light_point(const Light& light, Vec3 from, Vec2 sample) {
    // Another point of the light for each sample, spread evenly over what is seen of it.
    RT_TODO(light, from, sample);
    return light.position;
}

Real lit_share(const ShadowRays& rays) {
    // The share of the rays that reach the light.
    RT_TODO(rays);
    return 1;
}

Real share_error(const ShadowRays& rays) {
    // By how much that share may be wrong.
    RT_TODO(rays);
    return 0;
}

}  // namespace rt
