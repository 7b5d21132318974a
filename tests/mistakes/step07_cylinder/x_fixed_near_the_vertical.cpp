// origin: common in student programs: X = (1, 0, 0) where |Z.y| > 0.9999
// caught by: X and Y are at right angles to Z, however near it is to the vertical (MRT §7)
// sentence: Where Z is nearly vertical you take X = (1, 0, 0), which is not at right angles to it: the tube is seen upright. Take (0, 1, 0) ∧ Z wherever it is not 0.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const Vec3 z = cylinder.axis;
    const bool vertical = std::abs(z.y) > Real(0.9999);
    const Vec3 x = vertical ? Vec3(1, 0, 0) : unit(cross(Vec3(0, 1, 0), z));
    const Vec3 y = cross(z, x);
    const Vec3 from = ray.origin - cylinder.center;
    const Vec3 o(dot(from, x), dot(from, y), dot(from, z));
    const Vec3 d(dot(ray.direction, x), dot(ray.direction, y), dot(ray.direction, z));
    const Real a = d.x * d.x + d.y * d.y;
    const Real b = 2 * (o.x * d.x + o.y * d.y);
    const Real c = o.x * o.x + o.y * o.y - cylinder.radius * cylinder.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (interval.contains(t) && 2 * std::abs(o.z + t * d.z) <= cylinder.height) return t;
    return std::nullopt;
}

}  // namespace rt
