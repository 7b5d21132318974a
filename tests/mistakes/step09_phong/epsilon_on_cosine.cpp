// origin: invented
// caught by: diffuse light is by the cosine between L and N (CR §3.1, M1)
// sentence: You compare ⟨L, N⟩ with a constant above 0: light that grazes the surface counts as well.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Real cosine = dot(unit(light.position - surface.point), surface.normal);
    if (!(cosine > Real(1e-3))) return Color(0);
    return cosine * light.brightness * light.color * surface.material.color;
}

}  // namespace rt
