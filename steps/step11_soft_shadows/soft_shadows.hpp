// Stage 11: soft shadows (CR §3.3, with its samples corrected).
//
//   CR                 here
//   light.radius       light.radius, of a sphere around light.position
//   x, y, z            sample, two uniform numbers from 0 to 1, not rand()
//   pos                sample_light(…)
//   counter / SAMPLES  1 − visibility(…): CR counts the blocked rays
#pragma once

#include "common/scene/light.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// The number of shadow rays sent to a light, and the number of those that were not blocked.
struct ShadowRays {
    int sent = 0;
    int reached = 0;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// The point of the light's surface that a shadow ray from the given position aims at. Samples
/// uniform over [0, 1)² give points uniform over the visible part of the light: over
/// its solid angle. It is a point of the light for the samples at its rim too, to which a ray may
/// miss the sphere by a rounding. From inside the light, and for a light without a size, it is the
/// light's center.
[[nodiscard]] Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample);

/// The fraction of the light that reaches the surface. `sent` must be positive.
[[nodiscard]] Real visibility(const ShadowRays& rays);

/// The estimated standard error of visibility, for sample points that are at least as well spread
/// as independent ones, and at best as well spread as this stage's. It is positive even if all rays
/// or none were blocked, does not change if blocked and unblocked are exchanged, and approaches 0
/// as more rays are sent.
[[nodiscard]] Real visibility_error(const ShadowRays& rays);

}  // namespace rt
