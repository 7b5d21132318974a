#include "steps/step10_shadows/shadows.hpp"

namespace rt {

namespace {

/// In units of u times the largest coordinate: by how much the place where a shape meets the ray
/// near the light can be off.
constexpr Real roundings = 32;

Real largest(Vec3 v) {
    const Vec3 size = abs(v);
    return glm::max(size.x, glm::max(size.y, size.z));
}

}  // namespace

ShadowRay shadow_ray(const Surface& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.side;
    const Vec3 direction = light - origin;  // not made unit length: the light is at t = 1
    const Real near_light = roundings * unit_roundoff * glm::max(largest(origin), largest(light));
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = 1 - near_light / length(direction)}};
}

}  // namespace rt
