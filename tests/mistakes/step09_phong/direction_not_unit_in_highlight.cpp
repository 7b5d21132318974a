// origin: invented: L normalized for the diffuse term only
// caught by: where R points to the eye, the highlight is full (CR §3.1)
// sentence: You do not make L unit length before you reflect it: R is as long as the light is far away.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = light.position - surface.point;
    if (!(dot(to_light, surface.normal) > 0)) return Color(0);
    const Real alpha = dot(reflected(to_light, surface.normal), surface.to_eye);
    if (!(alpha > 0)) return Color(0);
    return surface.material.specular * std::pow(alpha, surface.material.shininess) *
           light.brightness * light.color;
}

}  // namespace rt
