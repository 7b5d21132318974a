// Stage 11, to be written. docs/step11_soft_shadows.md explains it, the header is its contract.
// Begin with sample_light: CR's cube, put at the light's center, then a disc, then the visible
// ball. Until visibility is written, all of a light arrives and there are no shadows;
// visibility_error matters only with --tolerance.
// `./course check 11` reports errors, `./course hint 11` prints the next hint.
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    // A different point of the light for each sample, uniform over its visible part.
    RT_TODO(light, from, sample);
    return light.position;
}

Real visibility(const ShadowRays& rays) {
    // The fraction of the rays that reach the light.
    RT_TODO(rays);
    return 1;
}

Real visibility_error(const ShadowRays& rays) {
    // The estimated error of that fraction.
    RT_TODO(rays);
    return 0;
}

}  // namespace rt
