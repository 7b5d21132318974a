// origin: seen in student repositories: d − 2 ⟨d, N⟩ N with L for d
// caught by: light leaves on the other side of the normal, at the same angle (CR §3.1)
// sentence: Your R has the wrong sign: L − 2 ⟨L, N⟩ N leads into the surface. L leads to the light, so R = 2 ⟨L, N⟩ N − L.
#include <algorithm>
#include <cmath>
#include "common/math/vector.hpp"
#include "steps/step09_phong/phong.hpp"
namespace rt {
Vec3 reflected(Vec3 L, Vec3 N) {
    return L - Real(2) * dot(L, N) * N;
}
Color ambient_term(const ShadingPoint& s, const Ambient& a) {
    return a.ratio * (a.color * s.material.color);
}
Color diffuse_term(const ShadingPoint& s, const Light& light) {
    if (light.position == s.point) return Color(0);
    const Vec3 L = unit(light.position - s.point);
    const Real theta = dot(L, s.normal);
    if (!(theta > 0)) return Color(0);
    return theta * light.brightness * light.color * s.material.color;
}
Color specular_term(const ShadingPoint& s, const Light& light) {
    if (light.position == s.point) return Color(0);
    const Vec3 L = unit(light.position - s.point);
    if (!(dot(L, s.normal) > 0)) return Color(0);
    const Vec3 R = reflected(L, s.normal);
    const Real alpha = dot(R, s.to_eye);
    if (!(alpha > 0)) return Color(0);
    return std::pow(alpha, s.material.shininess) * s.material.specular * light.brightness *
           light.color;
}
}  // namespace rt
