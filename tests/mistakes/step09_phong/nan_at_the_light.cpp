// origin: invented: 0 / 0 where the light stands at the point
// caught by: a light at the point itself shows nothing, and no NaN (contract)
// sentence: diffuse_term is not a number where the light stands at the point itself: L is 0 / 0. NaN < 0 is false, and std::max(NaN, 0) is NaN: test !(⟨L, N⟩ > 0).
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (cosine < 0) return Color(0);
    return cosine * light.brightness * light.color * surface.material.color;
}

}  // namespace rt
