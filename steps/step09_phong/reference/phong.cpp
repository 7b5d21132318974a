#include "steps/step09_phong/phong.hpp"

#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

Color shining(const Light& light) {
    return light.brightness * light.color;
}

}  // namespace

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    return 2 * dot(to_light, normal) * normal - to_light;
}

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    return ambient.ratio * ambient.color * surface.material.color;
}

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Real cosine = dot(unit(light.position - surface.point), surface.normal);
    if (!(cosine > 0)) return Color(0);  // black for NaN, where the light is at the point
    return cosine * shining(light) * surface.material.color;
}

Color specular_term(const ShadingPoint& surface, const Light& light) {
    if (surface.material.specular == 0) return Color(0);
    const Vec3 to_light = unit(light.position - surface.point);
    // No highlight without light, though ⟨R, V⟩ may be positive even there (erratum 14).
    if (!(dot(to_light, surface.normal) > 0)) return Color(0);
    const Real cosine = dot(reflected(to_light, surface.normal), surface.to_eye);
    if (!(cosine > 0)) return Color(0);
    return surface.material.specular * std::pow(cosine, surface.material.shininess) *
           shining(light);
}

}  // namespace rt
