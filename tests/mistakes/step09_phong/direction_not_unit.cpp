// origin: seen in student repositories
// caught by: how far away the light is does not matter (CR §3.1)
// sentence: You do not make L unit length: the further away the light is, the brighter is the surface.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Real cosine = dot(light.position - surface.point, surface.normal);
    if (!(cosine > 0)) return Color(0);
    return cosine * light.brightness * light.color * surface.material.color;
}

}  // namespace rt
