// origin: invented: the range ends at the light, to the last digit
// caught by: a lamp that lies in the ceiling is not shadowed by it (CR §2.4, §3.2)
// sentence: Your range ends at the light exactly, and by a rounding the ceiling that the lamp lies in is nearer. End a little before.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction}, .interval = {.min = 0, .max = 1}};
}

}  // namespace rt
