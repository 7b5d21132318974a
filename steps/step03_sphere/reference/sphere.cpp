#include "steps/step03_sphere/sphere.hpp"

#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    // PHY's discriminant, B² − 4AC of A t² + B t + C, loses half its digits for a distant sphere.
    // The half chord, computed from the point of the line that is closest to the center, does not.
    const Vec3 from_center = ray.origin - sphere.center;
    const Real along = dot(from_center, ray.direction);
    const Real rr = sphere.radius * sphere.radius;
    const Real c = dot(from_center, from_center) - rr;
    if (c > 0 && along > 0 && interval.min >= 0) return std::nullopt;  // outside, and away from it

    // t_near has the rounding errors of the origin's distance. The point p is nevertheless on the
    // line up to its own last digit, and what remains to the closest point is small.
    const Real inverse_a = 1 / dot(ray.direction, ray.direction);
    const Real t_near = -along * inverse_a;
    const Vec3 p = fused_at(from_center, t_near, ray.direction);
    const Real beyond = dot(p, ray.direction);
    const Real to_closest = -beyond * inverse_a;
    const Real half_chord_squared = rr - dot(p, p) - to_closest * beyond;
    if (!(half_chord_squared >= 0)) return std::nullopt;  // NaN must miss

    // The root of larger magnitude is a sum. Near the surface the other one is a difference, but
    // their product is C / A. If the origin is on the surface, C is exactly 0, and so is one root.
    // If the ray barely leaves the surface, both roots and C are rounding errors, and so is the
    // quotient: if it is wrong, its magnitude is larger than that of the sum, and the difference is
    // equally good. (r / |d|)² might leave the range of numbers: two square roots do not.
    const Real half_chord = std::copysign(std::sqrt(half_chord_squared), t_near);
    const Real inverse_length = std::sqrt(inverse_a);
    const Real t1 = t_near + std::fma(half_chord, inverse_length, to_closest);
    Real t2 = t_near + std::fma(-half_chord, inverse_length, to_closest);
    if (c == 0 || std::abs(t2) < std::abs(half_chord * inverse_length) / 4) {
        const Real quotient = c / t1 * inverse_a;
        if (std::abs(quotient) <= std::abs(t1)) t2 = quotient;
    }
    const Real near = std::min(t1, t2);
    const Real far = std::max(t1, t2);
    if (interval.contains(near)) return near;
    if (interval.contains(far)) return far;
    return std::nullopt;
}

Vec3 normal(const Sphere& sphere, Vec3 point) {
    return unit(point - sphere.center);
}

Color color_from_normal(Vec3 normal) {
    return abs(unit(normal));
}

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    if (point == eye) return 0;  // no direction and therefore no angle
    const Real cos_theta = dot(unit(normal), unit(eye - point));
    return glm::max(cos_theta, Real(0));
}

}  // namespace rt
