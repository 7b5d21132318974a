// right: the angles themselves, from M1's quotient; R by its parts along the normal and across
#include "steps/step09_phong/phong.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

/// M1: the scalar product over both lengths, clamped to 1 against rounding.
Real angle(Vec3 a, Vec3 b) {
    return std::acos(std::clamp(dot(a, b) / (length(a) * length(b)), Real(-1), Real(1)));
}

}  // namespace

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    const Vec3 along = dot(to_light, normal) * normal;
    const Vec3 across = to_light - along;
    return along - across;
}

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    return ambient.color * surface.material.color * ambient.ratio;
}

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Real theta = angle(surface.normal, light.position - surface.point);
    if (!(theta < pi / 2)) return Color(0);
    return surface.material.color * light.color * light.brightness * std::cos(theta);
}

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 to_light = light.position - surface.point;
    if (!(dot(surface.normal, to_light) > 0)) return Color(0);
    const Real alpha = angle(reflected(to_light, surface.normal), surface.to_eye);
    if (!(alpha < pi / 2)) return Color(0);
    return light.color * light.brightness * surface.material.specular *
           std::pow(std::cos(alpha), surface.material.shininess);
}

}  // namespace rt
