// origin: seen in student repositories: the cosine of an angle by acos
// caught by: a light straight above shows the full color (CR §3.1)
// sentence: acos of 1.0000001 is not a number, and rounding makes such products of unit vectors. ⟨L, N⟩ is the cosine: no angle is needed.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Real theta = std::acos(dot(unit(light.position - surface.point), surface.normal));
    if (!(theta < pi / 2)) return Color(0);
    return std::cos(theta) * light.brightness * light.color * surface.material.color;
}

}  // namespace rt
