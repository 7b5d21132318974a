// origin: invented: the ray from the light, up to the point
// caught by: a point that is off its surface by its error still sees the light (contract)
// sentence: Your ray starts at the light and ends at the point, so the surface itself blocks it. Start at the point, off the surface by its error.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = light;
    const Vec3 direction = surface.point - light;
    return {.ray = {.origin = origin, .direction = direction}, .interval = {.min = 0, .max = 1}};
}

}  // namespace rt
