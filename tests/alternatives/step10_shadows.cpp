// right aimed_from_the_point around shadow_ray: the direction from the point itself, twice the
// error off the surface, and eight times before the light
namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 direction = light - surface.point;
    return {.ray = {.origin = surface.point + 2 * surface.error * surface.geometric_normal,
                    .direction = direction},
            .interval = {.min = 0, .max = 1 - 8 * surface.error / length(direction)}};
}

}  // namespace rt

// right rounded_outwards around shadow_ray: pbrt's offset, rounded away from the surface
#include <cmath>

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    // Away from the surface by the error, then by one more digit in every coordinate, which
    // compensates for the rounding of the addition (Pharr, Jakob, Humphreys 2023, §6.8.6).
    Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    for (glm::length_t i = 0; i < 3; ++i)
        origin[i] =
            std::nextafter(origin[i], surface.geometric_normal[i] > 0 ? infinity : -infinity);
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = 1 - 1024 * unit_roundoff}};
}

}  // namespace rt

// right unit_direction around shadow_ray: CR §3.2's unit L and its distance, shortened by 1/10000
// before the light
#include "common/math/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = unit(light - origin);
    const Real distance = length(light - origin);
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.9999) * distance}};
}

}  // namespace rt
