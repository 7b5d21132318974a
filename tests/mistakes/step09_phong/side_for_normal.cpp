// origin: invented: surface.geometric_normal, which is for stage 10
// caught by: diffuse light is by the cosine between L and N (CR §3.1, M1)
// sentence: You take surface.geometric_normal for N. On a smooth mesh that is the flat face: N is surface.normal.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    ShadingPoint flat = surface;
    flat.normal = surface.geometric_normal;
    return correct_diffuse_term(flat, light);
}

}  // namespace rt
