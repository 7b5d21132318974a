// origin: invented: CR §3.3 centerd, erratum 16 half mended
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: You draw x, y and z from minus the radius to the radius: a cube around the light, whose corners stand out. The light is a sphere.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real third = glm::fract(7 * sample.x + 13 * sample.y);
    return light.position + light.radius * (Real(2) * Vec3(sample.x, sample.y, third) - Real(1));
}

}  // namespace rt
