// origin: invented: t ≤ distance, and a little more
// caught by: a lamp that lies in the ceiling is not shadowed by it (CR §2.4, §3.2)
// sentence: Your interval ends a little behind the light, so a surface around the lamp shadows it. End it a little before.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(1.001)}};
}

}  // namespace rt
