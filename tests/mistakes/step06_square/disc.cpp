// origin: invented: the distance from the center for |x| and |y|
// caught by: the side is h, from -h/2 to h/2 (MRT §6)
// sentence: You compare the distance from the center: that is a disc.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (square.one_sided && dot(ray.direction, square.basis.z) >= 0) return std::nullopt;
    const Real t =
        dot(square.center - ray.origin, square.basis.z) / dot(ray.direction, square.basis.z);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    const Real x = dot(p, square.basis.x);
    const Real y = dot(p, square.basis.y);
    if (!(x * x + y * y <= square.side * square.side / 4)) return std::nullopt;
    return t;
}

}  // namespace rt
