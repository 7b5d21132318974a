// origin: seen in student repositories: ε = 0.1
// caught by: a shape close to the surface casts a shadow at any scale (CR §3.2, erratum 31)
// sentence: You start 0.1 off the surface, whatever the scene's size: what stands closer throws no shadow, and where a rounding is larger there is acne. Take surface.error.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + Real(0.1) * surface.geometric_normal;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
