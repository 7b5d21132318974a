// origin: OpenGL: GL_SHININESS ends at 128
// caught by: the shininess need not be a whole number, nor small (CR §3.1)
// sentence: You cut the shininess off at 128, as OpenGL does. It may be any.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

#include <algorithm>

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    ShadingPoint dull = surface;
    dull.material.shininess = std::min(surface.material.shininess, Real(128));
    return correct_specular_term(dull, light);
}

}  // namespace rt
