// origin: invented: the distance less 0.001
// caught by: a shape close to the surface casts a shadow at any scale (CR §3.2, erratum 31)
// sentence: You end 0.001 before the light: in a small scene that is before the start, and nothing throws a shadow. End before it by a few roundings of the coordinates, or a small share of the way.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

#include "common/math/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point + surface.error * surface.geometric_normal;
    const Vec3 direction = unit(light - origin);
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = 0, .max = length(light - origin) - Real(0.001)}};
}

}  // namespace rt
