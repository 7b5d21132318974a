// origin: seen in student repositories: |N · L|
// caught by: a light behind the surface takes nothing away and adds nothing (erratum 27, M1)
// sentence: You take |⟨L, N⟩|: a surface is lit from behind. Where ⟨L, N⟩ is not positive, there is no light.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    return std::abs(cosine) * light.brightness * light.color * surface.material.color;
}

}  // namespace rt
