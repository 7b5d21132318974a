// origin: seen in student repositories
// caught by: a point that is off its surface by its error still sees the light (contract)
// sentence: You leave the surface along the ray: where it grazes the surface, that hardly leaves it. Move the origin along surface.geometric_normal.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

#include "common/math/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * unit(light - surface.point);
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
