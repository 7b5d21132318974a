// origin: invented: material.specular never read
// caught by: a surface without a specular part has no highlight (CR §3.1)
// sentence: You ignore the strength of the material's highlight: a matt one has no highlight.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    const Real alpha = dot(reflected(to_light, surface.normal), surface.to_eye);
    if (!(alpha > 0)) return Color(0);
    return std::pow(alpha, surface.material.shininess) * light.brightness * light.color;
}

}  // namespace rt
