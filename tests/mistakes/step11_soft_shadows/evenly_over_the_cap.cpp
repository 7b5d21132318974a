// origin: invented: the area that is seen, instead of its solid angle
// caught by: the points are spread evenly over the solid angle that the light fills (CR §3.3)
// sentence: Your points are even over the area that is seen. Near its rim that area is seen aslant, and should have fewer: spread the directions.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real z = 1 - sample.x * (1 - light.radius / distance(from, light.position));
    const Real across = std::sqrt(1 - z * z);
    const Real turn = 2 * pi * sample.y;
    const Basis basis = orthonormal_basis(unit(from - light.position));
    return light.position + light.radius * (across * std::cos(turn) * basis.x +
                                            across * std::sin(turn) * basis.y + z * basis.z);
}

}  // namespace rt
