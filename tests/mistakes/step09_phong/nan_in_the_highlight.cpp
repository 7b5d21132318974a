// origin: a student's: NaN <= 0 is false
// caught by: a light at the point itself shows nothing, and no NaN (contract)
// sentence: specular_term is not a number where the light stands at the point itself: L is 0 / 0. NaN <= 0 is false: test !(⟨L, N⟩ > 0), and !(⟨R, V⟩ > 0).
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    if (dot(to_light, surface.normal) <= 0) return Color(0);
    const Real cosine = dot(reflected(to_light, surface.normal), surface.to_eye);
    if (cosine <= 0) return Color(0);
    return surface.material.specular * std::pow(cosine, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
