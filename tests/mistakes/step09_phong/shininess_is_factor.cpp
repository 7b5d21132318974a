// origin: invented: shininess · α
// caught by: where R points to the eye, the highlight is full (CR §3.1)
// sentence: You multiply by the shininess. It is the exponent of ⟨R, V⟩.
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
    return surface.material.specular * surface.material.shininess * alpha * light.brightness *
           light.color;
}

}  // namespace rt
