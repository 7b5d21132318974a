// origin: invented: std::max(NaN, 0) is NaN
// caught by: NaN is dark: it is not positive (contract)
// sentence: specular_term is not a number where ⟨R, V⟩ is none: std::max(x, 0) and if (x <= 0) let NaN pass. std::max(0, x) gives 0, and !(x > 0) is the clear form.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

#include <algorithm>

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    const Real alpha = std::max(dot(reflected(to_light, surface.normal), surface.to_eye), Real(0));
    return surface.material.specular * std::pow(alpha, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
