// origin: invented: the light's position for its direction
// caught by: L leads from the point to the light, wherever both are (CR §3.1)
// sentence: You take the light's position for the direction to it. L is light.position − surface.point.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Real cosine = dot(unit(light.position), surface.normal);
    if (!(cosine > 0)) return Color(0);
    return cosine * light.brightness * light.color * surface.material.color;
}

}  // namespace rt
