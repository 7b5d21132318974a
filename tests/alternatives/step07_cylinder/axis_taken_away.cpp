// right: v − ⟨v, Z⟩ Z in place of v ∧ Z
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    const auto across = [&cylinder](Vec3 v) { return v - dot(v, cylinder.axis) * cylinder.axis; };
    const Vec3 from_center = ray.origin - cylinder.center;
    const Vec3 o = across(from_center);
    const Vec3 d = across(ray.direction);
    const Real a = dot(d, d);
    const Real half_b = dot(o, d);
    const Real c = dot(o, o) - cylinder.radius * cylinder.radius;
    const Real discriminant = half_b * half_b - a * c;
    if (a == 0 || !(discriminant >= 0)) return std::nullopt;
    for (const int sign : {-1, 1}) {
        const Real t = (-half_b + Real(sign) * std::sqrt(discriminant)) / a;
        const Real z = dot(from_center + t * ray.direction, cylinder.axis);
        if (interval.contains(t) && std::abs(z) <= cylinder.height / 2) return t;
    }
    return std::nullopt;
}

}  // namespace rt
