// origin: seen in student repositories
// caught by: a shape between the point and the light casts a shadow (CR §3.2)
// sentence: You make the direction a unit vector and compare t with 1: only what is nearer than 1 throws a shadow. Compare t with the distance, or leave the direction as long as the way.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

#include "common/math/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = unit(light - origin);
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
