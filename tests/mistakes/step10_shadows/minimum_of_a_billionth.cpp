// origin: a student's: t > 1e-9
// caught by: the offset does not grow with the distance of the light (contract)
// sentence: You leave out a small part of the way. It is as long as the light is far: start off the surface, and test t > 0.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    ShadowRay way = correct_shadow_ray(surface, light);
    way.interval.min = Real(1e-9);
    return way;
}

}  // namespace rt
