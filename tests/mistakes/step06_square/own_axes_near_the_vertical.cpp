// origin: seen in student programs: |Z.y| > 0.9999 takes X = (1, 0, 0)
// caught by: x and y are the basis', however near its Z is to the vertical (contract)
// sentence: Where Z is nearly vertical you take other axes than the square's. Its x and y are given, for every Z: use them.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 z = square.basis.z;
    const bool vertical = std::abs(z.y) > Real(0.9999);
    const Vec3 x = vertical ? Vec3(1, 0, 0) : square.basis.x;
    const Vec3 y = vertical ? cross(z, x) : square.basis.y;
    const Real approach = dot(ray.direction, square.basis.z);
    if (square.one_sided && approach >= 0) return std::nullopt;
    const Real t = dot(square.center - ray.origin, square.basis.z) / approach;
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    if (!(std::abs(dot(p, x)) <= square.side / 2)) return std::nullopt;
    if (!(std::abs(dot(p, y)) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
