// origin: invented: the sign of the offset
// caught by: a point that is off its surface by its error still sees the light (contract)
// sentence: You start on the far side of the surface, so it is in the way. surface.geometric_normal points to where the eye is.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point - surface.error * surface.geometric_normal;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
