#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "common/math/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Vec3 away = from - light.position;
    const auto [x, y, z] = orthonormal_basis(away);
    const Real distance =
        dot(away, z);  // as length(away), but without squares that over- or underflow
    // NaN, for a point at the light's center, counts as inside too.
    if (!(light.radius > 0) || !(distance > light.radius)) return light.position;

    // Uniform directions in the cone of the light: 1 − cos is uniform from 0 to its largest value,
    // which is sin² / (1 + cos), so that there is no cancellation for a small light (Pharr, Jakob,
    // Humphreys 2023, §6.2.4).
    const Real sine_max = light.radius / distance;
    const Real cosine_max = std::sqrt((1 - sine_max) * (1 + sine_max));
    const Real share = sample.x / (1 + cosine_max);
    const Real one_minus_cosine = share * sine_max * sine_max;
    const Real cosine = 1 - one_minus_cosine;

    // Where the direction enters the sphere, it makes an angle with the normal whose sine is sine /
    // sine_max, by the law of sines. Seen from the light's center, the angle between the point and
    // the axis is that angle minus the direction's.
    const Real slant_sine_squared = share * (2 - one_minus_cosine);
    const Real slant_sine = std::sqrt(slant_sine_squared);
    const Real slant_cosine = std::sqrt(std::max(1 - slant_sine_squared, Real(0)));
    const Real sine = slant_sine * sine_max;
    const Real polar_sine = slant_sine * cosine - slant_cosine * sine;
    const Real polar_cosine = slant_cosine * cosine + slant_sine * sine;

    const Real turn = 2 * pi * sample.y;
    return light.position + light.radius * (polar_sine * std::cos(turn) * x +
                                            polar_sine * std::sin(turn) * y + polar_cosine * z);
}

Real visibility(const ShadowRays& rays) {
    return Real(rays.reached) / Real(rays.sent);
}

Real visibility_error(const ShadowRays& rays) {
    // Each of n well-spread points represents one of n boxes, and only the boxes on the shadow's
    // edge are uncertain (Mitchell 1996). If a fraction p of the light is visible, the length of
    // the edge is about √p, and it crosses about √(p n) boxes, each with an error of about 1 / n of
    // either sign: (p n)^(1/4) / n in total. p (1 − p) replaces the smaller part. One more ray of
    // each kind prevents 0 (Agresti and Coull 1998): n rays that all agree may have missed about
    // one box. The factor is measured. With it the root mean square error is 0.75 to 0.85 of the
    // estimate, over straight edges at any position, or discs, for n = 8 to 1024, and no more if
    // only little of the light is hidden.
    constexpr Real factor = Real(0.7);
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return factor * std::pow(p * (1 - p), Real(0.25)) / std::pow(Real(rays.sent), Real(0.75));
}

}  // namespace rt
