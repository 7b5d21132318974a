// right: ⟨R, V⟩ as 2 ⟨L, N⟩ ⟨N, V⟩ − ⟨L, V⟩, the power by exp and log, GLM's reflect
#include "steps/step09_phong/phong.hpp"

#include <cmath>

namespace rt {

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    return reflect(-to_light, normal);
}

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    return surface.material.color * ambient.color * ambient.ratio;
}

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 way = light.position - surface.point;
    const Real along = dot(way, surface.normal);
    if (!(along > 0)) return Color(0);
    return along / length(way) * light.brightness * light.color * surface.material.color;
}

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 l = light.position - surface.point;
    const Real ln = dot(l, surface.normal);
    if (!(ln > 0)) return Color(0);
    const Real rv =
        (2 * ln * dot(surface.normal, surface.to_eye) - dot(l, surface.to_eye)) / length(l);
    if (!(rv > 0)) return Color(0);
    return surface.material.specular * std::exp(surface.material.shininess * std::log(rv)) *
           light.brightness * light.color;
}

}  // namespace rt
