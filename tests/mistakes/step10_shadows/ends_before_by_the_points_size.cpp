// origin: invented: only the coordinates of the ray's origin are looked at
// caught by: a lamp that lies in the ceiling is not shadowed by it (CR §2.4, §3.2)
// sentence: You end before the light by a few roundings of the point's coordinates. The light's may be larger: take the largest of both.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    auto [ray, interval] = correct_shadow_ray(surface, light);
    const Real near_light = ends_before * unit_roundoff * largest_component(ray.origin);
    interval.max = 1 - near_light / largest_component(ray.direction);
    return {.ray = ray, .interval = interval};
}

}  // namespace rt
