// right: within the height are points no farther from the center than a rim
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 z = cylinder.axis;
    const Vec3 aside = std::abs(z.y) < Real(0.9) ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = unit(cross(aside, z));
    const Vec3 y = cross(z, x);
    const Vec3 o = ray.origin - cylinder.center;
    const Vec3& d = ray.direction;
    const Real a = dot(d, x) * dot(d, x) + dot(d, y) * dot(d, y);
    const Real b = 2 * (dot(d, x) * dot(o, x) + dot(d, y) * dot(o, y));
    const Real c =
        dot(o, x) * dot(o, x) + dot(o, y) * dot(o, y) - cylinder.radius * cylinder.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)}) {
        const Vec3 from_center = o + t * d;
        const Real to_rim =
            cylinder.radius * cylinder.radius + cylinder.height * cylinder.height / 4;
        if (dot(from_center, from_center) <= to_rim && interval.contains(t)) return t;
    }
    return std::nullopt;
}

}  // namespace rt
