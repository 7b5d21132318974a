// origin: common in student programs: X = (1, 0, 0) where |Z.y| > 0.9999
// caught by: X and Y are at right angles to Z, however near it is to the vertical (MRT §8)
// sentence: Where Z is nearly vertical you take X = (1, 0, 0), which is not at right angles to it: the cone is seen upright. Take (0, 1, 0) ∧ Z wherever it is not 0.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    const Vec3 z = cone.axis;
    const bool vertical = std::abs(z.y) > Real(0.9999);
    const Vec3 x = vertical ? Vec3(1, 0, 0) : unit(cross(Vec3(0, 1, 0), z));
    const Vec3 y = cross(z, x);
    const Vec3 from = ray.origin - cone.apex;
    const Vec3 o(dot(from, x), dot(from, y), dot(from, z));
    const Vec3 d(dot(ray.direction, x), dot(ray.direction, y), dot(ray.direction, z));
    const Real k = (cone.radius / cone.height) * (cone.radius / cone.height);
    const Real a = d.x * d.x + d.y * d.y - k * d.z * d.z;
    const Real b = 2 * (o.x * d.x + o.y * d.y - k * o.z * d.z);
    const Real c = o.x * o.x + o.y * o.y - k * o.z * o.z;
    const Real discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Real root = std::sqrt(discriminant);
    Real first = (-b - root) / (2 * a);
    Real second = (-b + root) / (2 * a);
    if (a == 0) first = second = -c / b;
    if (second < first) std::swap(first, second);
    for (const Real t : {first, second}) {
        const Real height = o.z + t * d.z;
        if (interval.contains(t) && 0 <= height && height <= cone.height) return t;
    }
    return std::nullopt;
}

}  // namespace rt
