// origin: invented: a disc across the center
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: Right so far: these are the points of the disc, which are right from far away. The next part is the visible ball: from nearby the rim of the disc is not what is seen as the rim of the light.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real across = std::sqrt(sample.x);
    const Real turn = 2 * pi * sample.y;
    const Basis basis = orthonormal_basis(unit(from - light.position));
    return light.position +
           light.radius * across * (std::cos(turn) * basis.x + std::sin(turn) * basis.y);
}

}  // namespace rt
