// Stage 11: soft shadows (CR §3.3, its samples put right).
//
//   CR                 here
//   light.radius       light.radius, of a sphere around light.position
//   x, y, z            sample, two numbers from 0 to 1 that are spread evenly, not rand()
//   pos                light_point(…)
//   counter / SAMPLES  1 − lit_share(…): it counts the blocked ones
#pragma once

#include "common/scene.hpp"

namespace rt::inline RT_PRECISION {

/// How many shadow rays have been sent to a light, and how many of them were not blocked.
struct ShadowRays {
    int sent = 0;
    int reached = 0;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The point of the light's surface at which to aim from the given place. Samples spread evenly
/// over [0, 1)² make points spread evenly over all that can be seen of the light from there: over
/// the solid angle it fills. From inside the light, and for a light without a size, it is its
/// centre.
[[nodiscard]] Vec3 light_point(const Light& light, Vec3 from, Vec2 sample);

/// The share of the light that reaches the surface; sent is positive.
[[nodiscard]] Real lit_share(const ShadowRays& rays);

/// By how much lit_share may be wrong: its standard error, estimated for points that are at least
/// as even as independent ones, and at best as this stage's. It is positive even if all rays or
/// none were blocked, the same for either kind exchanged, and goes to 0 as more are sent.
[[nodiscard]] Real share_error(const ShadowRays& rays);

}  // namespace rt
