// origin: invented: any coordinate that is not 0 is left out, where Badouel leaves out the largest
// caught by: rays aimed at a point inside meet it there (MRT §5, M1)
// sentence: You leave out z unless the normal's z is 0. Near 0, the triangle seen along z is a line: leave out the coordinate in which the normal is largest.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    if (!interval.contains(t)) return std::nullopt;
    const glm::length_t left_out = n.z != 0 ? 2 : n.y != 0 ? 1 : 0;
    const auto seen = [left_out](Vec3 v) {
        return Vec2(v[(left_out + 1) % 3], v[(left_out + 2) % 3]);
    };
    const Vec2 p = seen(at(ray, t) - a);
    const Vec2 ab = seen(b - a);
    const Vec2 ac = seen(c - a);
    const Real area = ab.x * ac.y - ab.y * ac.x;
    const Real beta = (p.x * ac.y - p.y * ac.x) / area;
    const Real gamma = (ab.x * p.y - ab.y * p.x) / area;
    if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
    return t;
}

}  // namespace rt
