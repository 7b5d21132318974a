// origin: Blinn 1977: ⟨N, H⟩ in place of ⟨R, V⟩
// caught by: beside R the highlight is ⟨R, V⟩ to the power of the shininess (CR §3.1)
// sentence: You have Blinn's highlight, by the vector half-way between L and V. It is larger: CR §3.1 has Phong's, by ⟨R, V⟩.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    const Real alpha = dot(unit(to_light + surface.to_eye), surface.normal);
    if (!(alpha > 0)) return Color(0);
    return surface.material.specular * std::pow(alpha, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
