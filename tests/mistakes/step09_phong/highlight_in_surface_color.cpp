// origin: seen in student repositories
// caught by: the highlight has the light's color, not the surface's (CR §3.1)
// sentence: You multiply the highlight by the surface's color: a blue surface shows a blue one. It has the light's color.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    return surface.material.color * correct_specular_term(surface, light);
}

}  // namespace rt
