// origin: CR §2.2 listing, erratum 12
// caught by: behind the origin, nothing is met (CR §2.2, PHY)
// sentence: If the smaller root is negative, you return the larger one without testing that it is positive.
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
    const Real t1 = (-b - root) / (2 * a);
    const Real t2 = (-b + root) / (2 * a);
    const Real t = t1 > interval.min ? t1 : t2;
    if (!(t < interval.max)) return std::nullopt;
    return t;
}

}  // namespace rt
