// right: a unit direction, and half a side from the center
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 d = glm::normalize(ray.direction);
    const Real slope = glm::dot(d, square.basis.z);
    if (slope == 0 || (square.one_sided && slope > 0)) return std::nullopt;
    const Real distance = glm::dot(square.center - ray.origin, square.basis.z) / slope;
    const Real t = distance / glm::length(ray.direction);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = ray.origin + distance * d;
    const Real x = glm::dot(p - square.center, square.basis.x);
    const Real y = glm::dot(p - square.center, square.basis.y);
    const Real half = square.side * Real(0.5);
    if (x < -half || x > half || y < -half || y > half) return std::nullopt;
    return t;
}

}  // namespace rt
