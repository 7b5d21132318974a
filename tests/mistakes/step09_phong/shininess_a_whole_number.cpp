// origin: invented: pow by a loop
// caught by: the shininess need not be a whole number, nor small (CR §3.1)
// sentence: You cut the shininess off to a whole number. std::pow takes any.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    ShadingPoint whole = surface;
    whole.material.shininess = std::trunc(surface.material.shininess);
    return correct_specular_term(whole, light);
}

}  // namespace rt
