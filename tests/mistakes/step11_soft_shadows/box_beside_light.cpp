// origin: CR §3.3, erratum 16
// caught by: they are spread around the light's center, not beside it (CR §3.3, erratum 16)
// sentence: You draw x, y and z from 0 to the radius: a box beside the light, whose middle is half a radius off on each axis, and with it the penumbra. Spread the points over the light, around its center.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Real third = glm::fract(7 * sample.x + 13 * sample.y);  // for a third rand()
    return light.position + light.radius * Vec3(sample.x, sample.y, third);
}

}  // namespace rt
