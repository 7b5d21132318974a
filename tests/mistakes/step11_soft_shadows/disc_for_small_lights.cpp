// origin: invented: a disc looks alike from far away
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: For a light that looks small you aim at a disc through its center, which is inside of the light. The points are on the sphere for every size.
#define sample_light(...) correct_sample_light(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Vec3 away = from - light.position;
    if (!(light.radius < Real(0.05) * length(away)))
        return correct_sample_light(light, from, sample);
    const auto [x, y, z] = orthonormal_basis(away);
    const Real off = light.radius * std::sqrt(sample.x);
    const Real turn = 2 * pi * sample.y;
    return light.position + off * (std::cos(turn) * x + std::sin(turn) * y);
}

}  // namespace rt
