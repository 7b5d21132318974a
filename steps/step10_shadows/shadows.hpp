// Stage 10: shadows (CR §3.2; M1's exercise "et pour les ombres ?").
//
//   CR                 here
//   intersection       surface.point, at most surface.error from the shape
//   shadowRay          shadow_ray(…).ray
//   0.001, maxDist     shadow_ray(…).interval, and no constant
#pragma once

#include "common/geometry/ray.hpp"
#include "common/scene/shading_point.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// A ray from a surface to a light, and the interval in which a hit occludes the light.
struct ShadowRay {
    Ray ray;
    Interval interval;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// The shadow ray from the surface to the light. Its origin is off the surface, by surface.error or
/// a little more along surface.geometric_normal, so that it never hits the surface itself, and it
/// leads from there to the light. Everything else between the point and the light is inside the
/// interval; the light, what it lies in, and everything behind it are outside.
[[nodiscard]] ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light);

}  // namespace rt
