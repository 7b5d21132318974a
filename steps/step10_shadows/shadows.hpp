// Stage 10: shadows (CR §3.2; M1's exercise "et pour les ombres ?").
//
//   CR                 here
//   intersection       surface.point, which is on the shape to within surface.error
//   shadowRay          shadow_ray(…).ray
//   0.001, maxDist     shadow_ray(…).interval, and no constant
#pragma once

#include "common/ray.hpp"
#include "common/surface.hpp"

namespace rt::inline RT_PRECISION {

/// A ray from a surface to a light, and the part of it in which something would throw a shadow.
struct ShadowRay {
    Ray ray;
    Interval interval;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The way from the surface to the light. It starts off the surface, by surface.error or a little
/// more on surface.side, so that the surface itself is never met; everything else between the point
/// and the light is, and what is at the light or behind it is not.
[[nodiscard]] ShadowRay shadow_ray(const Surface& surface, Vec3 light);

}  // namespace rt
