// right: CR §3.1's listing in three functions, with erratum 14 put right
#include "steps/step09_phong/phong.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    return 2 * dot(to_light, normal) * normal - to_light;
}

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    const Color light_material = ambient.ratio * ambient.color;
    return light_material * surface.material.color;
}

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    if (light.position == surface.point) return Color(0);
    const Vec3 l = normalize(light.position - surface.point);
    const Real theta = std::max(Real(0), dot(l, surface.normal));  // 0 for NaN, in this order
    return light.brightness * light.color * surface.material.color * theta;
}

Color specular_term(const ShadingPoint& surface, const Light& light) {
    if (light.position == surface.point) return Color(0);
    const Vec3 l = normalize(light.position - surface.point);
    const Real theta = std::max(Real(0), dot(l, surface.normal));
    if (theta == 0) return Color(0);
    const Vec3 reflexion = normalize(reflected(l, surface.normal));
    const Real alpha = std::max(Real(0), dot(reflexion, surface.to_eye));
    return light.brightness * light.color * surface.material.specular *
           std::pow(alpha, surface.material.shininess);
}

}  // namespace rt
