// origin: invented: t > 0.001 of a direction as long as the way
// caught by: a point that is off its surface by its error still sees the light (contract)
// sentence: You leave out a thousandth of the way: near the surface, what stands there is lost, and where the ray grazes the surface it meets it even then. Move the origin by surface.error on surface.geometric_normal.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = Real(0.001), .max = Real(0.999)}};
}

}  // namespace rt
