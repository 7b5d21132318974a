// origin: invented
// caught by: beside R the highlight is ⟨R, V⟩ to the power of the shininess (CR §3.1)
// sentence: You compare ⟨R, V⟩ with a constant above 0. With a small shininess the highlight is wide, and this edge is seen.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    if (dot(reflected(to_light, surface.normal), surface.to_eye) < Real(1e-3)) return Color(0);
    return correct_specular_term(surface, light);
}

}  // namespace rt
