#include "steps/step10_shadows/shadows.hpp"

#include "common/vector.hpp"

namespace rt {

namespace {

/// In units of u times the largest coordinate: how far before the light the ray ends. A
/// flat shape that the light lies in is met up to 8 units off, measured across it: this keeps a
/// lamp in the ceiling from being shadowed by the ceiling where the ray comes to it at 4° or more.
constexpr Real ends_before = 128;

}  // namespace

ShadowRay shadow_ray(const Surface& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.side;
    const Vec3 direction = light - origin;  // not made unit length: the light is at t = 1
    const Real near_light =
        ends_before * unit_roundoff * glm::max(largest_component(origin), largest_component(light));
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = 1 - near_light / largest_component(direction)}};
}

}  // namespace rt
