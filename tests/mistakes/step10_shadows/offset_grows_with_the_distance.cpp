// origin: invented: an epsilon relative to the way
// caught by: the offset does not grow with the distance of the light (contract)
// sentence: Your offset grows with the distance of the light, but what the point is off by does not. Take surface.error.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin =
        surface.point + Real(0.001) * distance(surface.point, light) * surface.geometric_normal;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
