// origin: CR §2.1 listing, erratum 13
// caught by: near hits count as much as far ones: no epsilon on t (CR §2.1)
// sentence: You drop what is nearer than some distance. Only t ≤ 0 is dropped (PHY).
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 from_center = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = 2 * dot(from_center, ray.direction);
    const Real c = dot(from_center, from_center) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (interval.contains(t) && t > Real(4.9)) return t;
    return std::nullopt;
}

}  // namespace rt
