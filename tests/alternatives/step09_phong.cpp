// right as_printed: CR §3.1's listing in three functions, with erratum 14 put right
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

// right by_angles: the angles themselves, from M1's quotient; R by its parts along the normal and
// across
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

// right without_r: ⟨R, V⟩ as 2 ⟨L, N⟩ ⟨N, V⟩ − ⟨L, V⟩, the power by exp and log, GLM's reflect
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
