// origin: seen in student repositories: ⟨L, N⟩ to the power
// caught by: the highlight moves with the eye (CR §3.1)
// sentence: Your highlight stays where it is when the eye moves. It is ⟨R, V⟩ that counts, and V leads to the eye.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    const Real alpha = cosine;
    return surface.material.specular * std::pow(alpha, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
