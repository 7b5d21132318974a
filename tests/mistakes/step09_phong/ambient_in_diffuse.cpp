// origin: course/mistakes.md: ambient multiplied into the diffuse term
// caught by: diffuse light is by the cosine between L and N (CR §3.1, M1)
// sentence: Your diffuse term is multiplied by the surface's color twice: the terms are added, and each has it once.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    return surface.material.color * correct_diffuse_term(surface, light);
}

}  // namespace rt
