// origin: invented: back along the camera ray
// caught by: a point that is off its surface by its error still sees the light (contract)
// sentence: You move towards the eye: where it grazes the surface, that hardly leaves it. Move along surface.geometric_normal.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.to_eye;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
