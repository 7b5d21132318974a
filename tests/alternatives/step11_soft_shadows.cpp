// right concentric around sample_light visibility: the square laid on a disc without tearing it
// (Shirley and Chiu 1997), and the blocked counted
namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Real a = 2 * sample.x - 1;
    const Real b = 2 * sample.y - 1;
    if (a == 0 && b == 0) return correct_sample_light(light, from, {0, 0});
    const bool wide = std::abs(a) > std::abs(b);
    const Real across = wide ? a : b;
    const Real angle = wide ? pi / 4 * b / a : pi / 2 - pi / 4 * a / b;
    const Real turns = angle / (2 * pi) + (across < 0 ? Real(0.5) : 0);
    return correct_sample_light(light, from, {across * across, turns});
}

Real visibility(const ShadowRays& rays) {
    const int blocked = rays.sent - rays.reached;
    return 1 - Real(blocked) / Real(rays.sent);
}

}  // namespace rt

// right cone_and_sphere around sample_light: a direction in the cone, and stage 3's intersection
// with the sphere
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Vec3 way = light.position - from;
    const Real distance = length(way);
    if (light.radius == 0 || distance <= light.radius) return light.position;
    const Real sine_max = light.radius / distance;
    const Real cosine_max = std::sqrt(1 - sine_max * sine_max);
    const Real drop = sample.x * sine_max * sine_max / (1 + cosine_max);  // 1 − cos θ
    const Real sine = std::sqrt(drop * (2 - drop));
    const Real turn = 2 * pi * sample.y;
    const Vec3 z = way / distance;
    const Vec3 aside = std::abs(z.y) < Real(0.9) ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = unit(cross(aside, z));
    const Vec3 y = cross(z, x);
    const Ray ray{.origin = from,
                  .direction = sine * (std::cos(turn) * x + std::sin(turn) * y) + (1 - drop) * z};
    const std::optional<Real> t =
        intersect(ray, Sphere{.center = light.position, .radius = light.radius}, Interval{});
    return at(ray, t ? *t : distance * cosine_max);  // rounding: at the rim
}

}  // namespace rt

// right pbrt around sample_light visibility_error: as in pbrt (Pharr, Jakob, Humphreys 2023,
// §6.2.4), and the error of independent points
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
