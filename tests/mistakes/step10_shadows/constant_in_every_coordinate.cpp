// origin: seen in student repositories: (ε, ε, ε)
// caught by: a point that is off its surface by its error still sees the light (contract)
// sentence: You add a constant to every coordinate: on half of all surfaces that leads inside, and its size fits one scene. Start off the surface by surface.error on surface.geometric_normal.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + Vec3(Real(0.001));
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
