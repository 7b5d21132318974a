// origin: invented: V for L
// caught by: diffuse light does not depend on the eye or on the highlight (CR §3.1)
// sentence: Your diffuse term depends on the eye. A matt surface has the same color from everywhere.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    if (!(cosine > 0)) return Color(0);
    return dot(surface.to_eye, surface.normal) * light.brightness * light.color *
           surface.material.color;
}

}  // namespace rt
