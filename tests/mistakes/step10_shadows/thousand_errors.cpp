// origin: invented: to be on the safe side
// caught by: the offset is no more than a little: ten errors above, all is met (contract)
// sentence: You start a thousand errors above the surface, and what stands below throws no shadow. The error itself is enough.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + 1000 * surface.error * surface.geometric_normal;
    const Vec3 direction = light - origin;
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = Real(0.999)}};
}

}  // namespace rt
