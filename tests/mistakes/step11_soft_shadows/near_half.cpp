// origin: invented: the half of the sphere that faces the point
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: You take all of the half that faces the point. From nearby less than half is seen: up to the circle where the tangents touch.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real z = 1 - sample.x;
    const Real across = std::sqrt(1 - z * z);
    const Real turn = 2 * pi * sample.y;
    const Basis basis = orthonormal_basis(unit(from - light.position));
    return light.position + light.radius * (across * std::cos(turn) * basis.x +
                                            across * std::sin(turn) * basis.y + z * basis.z);
}

}  // namespace rt
