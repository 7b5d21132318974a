// origin: seen in student repositories
// caught by: where R points away from the eye, there is no highlight (CR §3.1)
// sentence: You raise a negative ⟨R, V⟩ to a power: with an even exponent a highlight shines on the wrong side, with a fraction it is not a number.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    const Real alpha = dot(reflected(to_light, surface.normal), surface.to_eye);
    return surface.material.specular * std::pow(alpha, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
