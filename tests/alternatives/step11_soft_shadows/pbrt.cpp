// right: as in pbrt (Pharr, Jakob, Humphreys 2023, §6.2.4), and the error of independent points
#define sample_light(...) correct_light_point(__VA_ARGS__)
#define visibility_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light
#undef visibility_error

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Real distance = length(light.position - from);
    if (!(light.radius > 0) || !(distance > light.radius)) return light.position;
    const Real sin_max = light.radius / distance;
    const Real sin2_max = sin_max * sin_max;
    const Real cos_max = std::sqrt(std::max(Real(0), 1 - sin2_max));
    Real cos_theta = (cos_max - 1) * sample.x + 1;
    Real sin2_theta = 1 - cos_theta * cos_theta;
    if (sin2_max < Real(0.00068523)) {  // 1.5 degrees: by Taylor's series
        sin2_theta = sin2_max * sample.x;
        cos_theta = std::sqrt(1 - sin2_theta);
    }
    const Real cos_alpha =
        sin2_theta / sin_max + cos_theta * std::sqrt(std::max(1 - sin2_theta / sin2_max, Real(0)));
    const Real sin_alpha = std::sqrt(std::max(Real(0), 1 - cos_alpha * cos_alpha));
    const Real phi = 2 * pi * sample.y;
    const Basis basis = orthonormal_basis((from - light.position) / distance);
    return light.position +
           light.radius * (sin_alpha * std::cos(phi) * basis.x +
                           sin_alpha * std::sin(phi) * basis.y + cos_alpha * basis.z);
}

Real visibility_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return std::sqrt(p * (1 - p) / Real(rays.sent));
}

}  // namespace rt
