// right: CR §2.3, edge by edge, with ≥
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 n = square.basis.z;
    if (square.one_sided && dot(ray.direction, n) >= 0) return std::nullopt;
    const Real t = dot(square.center - ray.origin, n) / dot(ray.direction, n);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t);
    const Vec3 x = square.basis.x * (square.side / 2);
    const Vec3 y = square.basis.y * (square.side / 2);
    const Vec3 corners[] = {square.center - x - y, square.center + x - y, square.center + x + y,
                            square.center - x + y};
    for (int i = 0; i < 4; ++i) {
        const Vec3 edge = corners[(i + 1) % 4] - corners[i];
        if (!(dot(cross(edge, p - corners[i]), n) >= 0)) return std::nullopt;
    }
    return t;
}

}  // namespace rt
