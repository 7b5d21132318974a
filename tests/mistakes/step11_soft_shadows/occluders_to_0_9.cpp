// origin: CR §3.3, erratum 16
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: You aim 0.9 along a unit direction: what stands farther off throws no shadow, and what is behind a near light does. Return the point of the light itself.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    return from + Real(0.9) * unit(correct_light_point(light, from, sample) - from);
}

}  // namespace rt
