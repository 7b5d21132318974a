// origin: invented: the ray's direction for V
// caught by: where R points to the eye, the highlight is full (CR §3.1)
// sentence: You take the direction of the ray for V. V leads back to the eye.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    const Real alpha = dot(reflected(to_light, surface.normal), -surface.to_eye);
    if (!(alpha > 0)) return Color(0);
    return surface.material.specular * std::pow(alpha, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
