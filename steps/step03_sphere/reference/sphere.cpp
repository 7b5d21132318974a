#include "steps/step03_sphere/sphere.hpp"

#include "common/vector.hpp"

#include <cmath>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    // PHY's A t² + B t + C loses half its digits in B² − 4AC when the sphere is far away. The
    // same roots lie a half chord on either side of the point of the line nearest to the centre.
    const Vec3 from_center = ray.origin - sphere.center;
    const Real dd = dot(ray.direction, ray.direction);
    const Real t_closest = -dot(from_center, ray.direction) / dd;
    const Vec3 closest = from_center + t_closest * ray.direction;
    const Real half_chord_squared = sphere.radius * sphere.radius - dot(closest, closest);
    if (!(half_chord_squared >= 0)) return std::nullopt;  // NaN must miss

    const Real half_chord = std::sqrt(half_chord_squared / dd);
    for (const Real t : {t_closest - half_chord, t_closest + half_chord})
        if (interval.contains(t)) return t;
    return std::nullopt;
}

Vec3 normal(const Sphere& sphere, Vec3 point) {
    return unit(point - sphere.center);
}

Color color_from_normal(Vec3 normal) {
    return abs(unit(normal));
}

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    const Real cos_theta = dot(unit(normal), unit(eye - point));
    return glm::max(cos_theta, Real(0));
}

}  // namespace rt
