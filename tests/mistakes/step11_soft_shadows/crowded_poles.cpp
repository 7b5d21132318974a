// origin: invented: two angles drawn evenly
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: You draw two angles evenly: points all over the sphere, also on its far side, and crowded at its poles.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real polar = pi * sample.x;
    const Real turn = 2 * pi * sample.y;
    return light.position + light.radius * Vec3(std::sin(polar) * std::cos(turn), std::cos(polar),
                                                std::sin(polar) * std::sin(turn));
}

}  // namespace rt
