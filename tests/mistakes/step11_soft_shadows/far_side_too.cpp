// origin: invented: points all over the sphere
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: Half of your points lie on the far side of the light, where they cannot be seen, and are counted free through the light itself. Take what is seen from the point.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real z = 1 - 2 * sample.x;
    const Real across = std::sqrt(1 - z * z);
    const Real turn = 2 * pi * sample.y;
    return light.position +
           light.radius * Vec3(across * std::cos(turn), across * std::sin(turn), z);
}

}  // namespace rt
