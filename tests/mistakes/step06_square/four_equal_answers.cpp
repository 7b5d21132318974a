// origin: CR §2.3, erratum 23
// caught by: a ray in the square's plane misses (MRT §6)
// sentence: You test whether four answers are equal, not whether they are yes. At a point that is not a number all four are no: all four must be yes.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 n = square.basis.z;
    if (square.one_sided && dot(ray.direction, n) >= 0) return std::nullopt;
    const Real t = dot(square.center - ray.origin, n) / dot(ray.direction, n);
    if (t <= interval.min || t >= interval.max) return std::nullopt;
    const Vec3 p = at(ray, t);
    const Vec3 x = square.basis.x * (square.side / 2);
    const Vec3 y = square.basis.y * (square.side / 2);
    const Vec3 corners[] = {square.center - x - y, square.center + x - y, square.center + x + y,
                            square.center - x + y};
    const auto answer = [&](int i) {
        return dot(cross(corners[(i + 1) % 4] - corners[i], p - corners[i]), n) >= 0;
    };
    const bool same = answer(0) == answer(1) && answer(1) == answer(2) && answer(2) == answer(3);
    return same ? std::optional(t) : std::nullopt;
}

}  // namespace rt
