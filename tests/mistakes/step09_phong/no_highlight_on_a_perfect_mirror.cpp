// origin: invented
// caught by: beside R the highlight is ⟨R, V⟩ to the power of the shininess (CR §3.1)
// sentence: A perfect mirror has no highlight in your answer. The terms do not depend on the mirror's share: stage 12 mixes their sum with the reflection.
#define specular_term(...) correct_specular_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef specular_term

namespace rt {

Color specular_term(const ShadingPoint& surface, const Light& light) {
    return surface.material.mirror == 1 ? Color(0) : correct_specular_term(surface, light);
}

}  // namespace rt
