// origin: MRT §3, erratum 1
// caught by: the unit sphere five ahead is hit at 4: + r² in the discriminant (MRT §3)
// sentence: Your discriminant subtracts r². MRT §3 is misprinted: ‖o_r − o‖² = r² gives + r².
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    const Vec3 to_center = sphere.center - ray.origin;
    const Real dd = dot(ray.direction, ray.direction);
    const Real along = dot(ray.direction, to_center);
    const Real discriminant =
        along * along - dd * (dot(to_center, to_center) + sphere.radius * sphere.radius);
    if (!(discriminant >= 0)) return std::nullopt;
    for (const Real t :
         {(along - std::sqrt(discriminant)) / dd, (along + std::sqrt(discriminant)) / dd})
        if (interval.contains(t)) return t;
    return std::nullopt;
}

}  // namespace rt
