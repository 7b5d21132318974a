// origin: CR §3.1, erratum 14
// caught by: without light there is no highlight, though ⟨R, V⟩ > 0 (erratum 14, CR §3.1)
// sentence: You show a highlight without light: test first that ⟨L, N⟩ is positive.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real alpha = dot(reflected(to_light, surface.normal), surface.to_eye);
    if (!(alpha > 0)) return Color(0);
    return surface.material.specular * std::pow(alpha, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
