// right: CR §3.2's unit L and its distance, shortened by 1/10000 before the light
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

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
