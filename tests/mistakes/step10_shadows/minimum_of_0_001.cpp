// origin: CR §3.2, erratum 31
// caught by: a shape close to the surface casts a shadow at any scale (CR §3.2, erratum 31)
// sentence: You test t > 0.001, as CR §3.2 prints. That is a length: larger than a small scene, and less than a rounding in a large one. Start off the surface by surface.error.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

#include "common/math/vector.hpp"

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const Vec3 origin = surface.point;
    const Vec3 direction = unit(light - origin);
    return {.ray = {.origin = origin, .direction = direction},
            .interval = {.min = Real(0.001), .max = length(light - origin)}};
}

}  // namespace rt
