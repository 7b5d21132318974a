// right: pbrt's offset, rounded away from the surface
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

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
