// origin: invented: any hit counts, as for the camera
// caught by: a shape behind the light casts no shadow (CR §3.2, maxDist)
// sentence: You count what is behind the light. The range ends at the light (CR §3.2's maxDist).
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction}, .interval = {}};
}

}  // namespace rt
