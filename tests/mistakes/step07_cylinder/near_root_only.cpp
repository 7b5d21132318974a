// origin: seen in student repositories
// caught by: into the open top, the far inside is met: both roots are tried (MRT §7)
// sentence: You try the smaller root only. If it lies outside the rim, the larger one is on the inside of the tube.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 from_center = ray.origin - cylinder.center;
    const Vec3 o = cross(from_center, cylinder.axis);
    const Vec3 d = cross(ray.direction, cylinder.axis);
    const Real a = dot(d, d);
    const Real b = 2 * dot(o, d);
    const Real c = dot(o, o) - cylinder.radius * cylinder.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    const Real t = (-b - root) / (2 * a);
    const Real z = dot(from_center + t * ray.direction, cylinder.axis);
    if (!(std::abs(z) <= cylinder.height / 2 && interval.contains(t))) return std::nullopt;
    return t;
}

}  // namespace rt
