#include "steps/step10_shadows/shadows.hpp"

#include "common/math/vector.hpp"

namespace rt {

namespace {

/// The distance from the end of the ray to the light, in units of u times the largest coordinate. A
/// flat shape that contains the light is hit up to 34 units off, measured across it
/// (docs/reference/error_bounds.md): this distance prevents the shadow of a ceiling on its own lamp
/// if the ray arrives at 16° or more.
constexpr Real ends_before = 128;

}  // namespace

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = light - origin;  // not of unit length: the light is at t = 1
    const Real near_light =
        ends_before * unit_roundoff * glm::max(largest_component(origin), largest_component(light));
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = 1 - near_light / largest_component(direction)}};
}

}  // namespace rt
