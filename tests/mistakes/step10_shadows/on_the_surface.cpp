// origin: seen in student repositories: acne
// caught by: a surface does not shadow itself at any scale: no acne (CR §3.2, erratum 31)
// sentence: Your ray starts on the surface, give or take a rounding, and half of the time meets it at once: acne. Start off it, by surface.error on surface.geometric_normal.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
