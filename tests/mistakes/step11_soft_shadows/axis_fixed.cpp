// origin: invented: the light's own frame left upright
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: Your cone opens along y, whatever the direction to the light. Build a basis around that direction.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Vec3 above = light.position + Vec3(0, distance(from, light.position), 0);
    return correct_light_point(light, above, sample);
}

}  // namespace rt
