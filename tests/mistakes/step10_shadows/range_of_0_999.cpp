// origin: a student's: a thousandth before the light
// caught by: a shape close to the light casts a shadow at any scale (CR §3.2, erratum 31)
// sentence: You end a thousandth of the way before the light: what is nearer to it throws no shadow. End before it by a few roundings of the coordinates.
#define shadow_ray(...) correct_shadow_ray(__VA_ARGS__)
#include "steps/step10_shadows/reference/shadows.cpp"
#undef shadow_ray

namespace rt {

ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    ShadowRay way = correct_shadow_ray(surface, light);
    way.interval.max = Real(0.999);
    return way;
}

}  // namespace rt
