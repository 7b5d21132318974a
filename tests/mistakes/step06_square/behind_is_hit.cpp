// origin: seen in student repositories
// caught by: behind the origin, nothing is met (PHY, t positive)
// sentence: You do not test whether t is positive: the square behind the eye is seen.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (square.one_sided && dot(ray.direction, square.basis.z) >= 0) return std::nullopt;
    const Real t =
        dot(square.center - ray.origin, square.basis.z) / dot(ray.direction, square.basis.z);
    if (!(t < interval.max && t > -infinity)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    const Real x = dot(p, square.basis.x);
    const Real y = dot(p, square.basis.y);
    if (!(std::abs(x) <= square.side / 2 && std::abs(y) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
