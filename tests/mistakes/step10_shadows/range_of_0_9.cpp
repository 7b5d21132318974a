// origin: CR §3.3, erratum 16
// caught by: a shape between the point and the light casts a shadow (CR §3.2)
// sentence: You look 0.9 units far, whatever the distance of the light, as CR §3.3 prints. The range ends at the light.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

#include "common/math/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = unit(light - origin);
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.9)}};
}

}  // namespace rt
