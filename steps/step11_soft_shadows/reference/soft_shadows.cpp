#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "common/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <cmath>

namespace rt {

Vec3 light_point(const Light& light, Vec3 from, Vec2 sample) {
    const Vec3 away = from - light.position;
    const Real distance = length(away);
    if (!(light.radius > 0) || !(distance > light.radius)) return light.position;

    // Directions within the cone that the light fills, evenly: 1 − cos is even from 0 to its
    // largest value, written so that a small light does not cancel (Pharr, Jakob, Humphreys 2023,
    // §6.2.4).
    const Real sine_max = light.radius / distance;
    const Real cosine_max = std::sqrt((1 - sine_max) * (1 + sine_max));
    const Real one_minus_cosine = sample.x * sine_max * sine_max / (1 + cosine_max);
    const Real sine_squared = one_minus_cosine * (2 - one_minus_cosine);

    // Where the direction enters the sphere, as seen from the light's centre: at the angle `polar`
    // from the axis, by the law of sines.
    const Real sine = std::sqrt(sine_squared);
    const Real sine_at_light = sine / sine_max;
    const Real cosine_at_light = std::sqrt(std::max(1 - sine_at_light * sine_at_light, Real(0)));
    const Real cosine_polar = sine * sine_at_light + (1 - one_minus_cosine) * cosine_at_light;
    const Real sine_polar = std::sqrt(std::max(1 - cosine_polar * cosine_polar, Real(0)));
    const Real turn = 2 * pi * sample.y;
    const auto [x, y, z] = basis_around(away / distance);
    return light.position + light.radius * (sine_polar * std::cos(turn) * x +
                                            sine_polar * std::sin(turn) * y + cosine_polar * z);
}

Real lit_share(const ShadowRays& rays) {
    return Real(rays.reached) / Real(rays.sent);
}

Real share_error(const ShadowRays& rays) {
    // Of independent points it would be √(p (1 − p) / n). Of points as even as these it falls
    // faster, by n^(3/4), since only the boxes on the shadow's edge are in doubt (Mitchell 1996).
    // One more of each kind keeps p off 0 and 1 (Agresti and Coull 1998).
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return std::sqrt(p * (1 - p)) / std::pow(Real(rays.sent), Real(0.75));
}

}  // namespace rt
