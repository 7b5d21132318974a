// origin: seen in student repositories
// caught by: brightness and color of the light multiply what it shows (CR §3.1)
// sentence: You leave out the light's brightness: its color is multiplied by it.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    return cosine * light.color * surface.material.color;
}

}  // namespace rt
