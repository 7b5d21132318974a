// origin: HAI: the corners worked out once, and not moved
// caught by: x and y are the square's own, not the world's (MRT §6)
// sentence: Your x and y are along a basis of your own around Z, not the square's: it does not turn with it.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    if (square.one_sided && dot(ray.direction, square.basis.z) >= 0) return std::nullopt;
    const Vec3 aside = std::abs(square.basis.z.y) < Real(0.999) ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 own_x = normalize(cross(aside, square.basis.z));
    const Vec3 own_y = cross(square.basis.z, own_x);
    const Real t =
        dot(square.center - ray.origin, square.basis.z) / dot(ray.direction, square.basis.z);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    const Real x = dot(p, own_x);
    const Real y = dot(p, own_y);
    if (!(std::abs(x) <= square.side / 2 && std::abs(y) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt
