// origin: invented: the same distance at both ends
// caught by: a lamp that lies in the ceiling is not shadowed by it (CR §2.4, §3.2)
// sentence: You end before the light by the surface's error. How the light's own coordinates are rounded does not follow from it: a lamp far away is shadowed by its ceiling.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    auto [ray, interval] = correct_shadow_ray(surface, light);
    interval.max = 1 - surface.error / length(ray.direction);
    return {.ray = ray, .interval = interval};
}

}  // namespace rt
