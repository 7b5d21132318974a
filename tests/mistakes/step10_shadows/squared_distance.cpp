// origin: invented: dot(L, L) for its root
// caught by: a shape behind the light casts no shadow (CR §3.2, maxDist)
// sentence: Your interval reaches as far as the square of the distance: t is compared with the distance of a direction that is not a unit vector (there the light is at t = 1), or with dot(L, L), without its root.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

#include "common/math/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = unit(light - origin);
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = dot(light - origin, light - origin)}};
}

}  // namespace rt
