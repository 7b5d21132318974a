// right gram around barycentric: the weights by the products of two sides with each other and with
// p − a (Ericson 2005)
namespace rt {

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    const Vec3 u = triangle.b - triangle.a;
    const Vec3 v = triangle.c - triangle.a;
    const Vec3 w = point - triangle.a;
    const Real determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
    const Real beta = (dot(v, v) * dot(w, u) - dot(u, v) * dot(w, v)) / determinant;
    const Real gamma = (dot(u, u) * dot(w, v) - dot(u, v) * dot(w, u)) / determinant;
    return {1 - beta - gamma, beta, gamma};
}

}  // namespace rt

// right half_planes around intersect: MRT §5, with ≥
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const Real t = dot(a - ray.origin, n) / dot(ray.direction, n);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t);
    const bool inside = dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
                        dot(cross(a - c, p - c), n) >= 0;
    if (!inside) return std::nullopt;
    return t;
}

}  // namespace rt

// right moller_trumbore around intersect: Möller and Trumbore 1997 (M1), without an epsilon
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const Vec3 u = triangle.b - triangle.a;
    const Vec3 v = triangle.c - triangle.a;
    const Vec3 q = cross(ray.direction, v);
    const Real determinant = dot(u, q);
    const Vec3 s = ray.origin - triangle.a;
    const Vec3 r = cross(s, u);
    const Real beta = dot(s, q) / determinant;
    const Real gamma = dot(ray.direction, r) / determinant;
    const Real t = dot(v, r) / determinant;
    if (!(beta >= 0 && gamma >= 0 && beta + gamma <= 1 && interval.contains(t)))
        return std::nullopt;
    return t;
}

}  // namespace rt

// right signed_areas around intersect: the weights of the point, none of them negative (CR §4.1
// with signs)
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const Vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const Real approach = dot(ray.direction, n);
    if (approach == 0) return std::nullopt;
    const Real t = dot(triangle.a - ray.origin, n) / approach;
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 w = barycentric(triangle, at(ray, t));
    if (!(w.x >= 0 && w.y >= 0 && w.z >= 0)) return std::nullopt;
    return t;
}

}  // namespace rt

// right unit_vectors around intersect: MRT §5 with a unit normal and a unit direction
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = glm::normalize(cross(b - a, c - a));
    const Vec3 d = glm::normalize(ray.direction);
    const Real slope = dot(n, d);
    if (slope == 0) return std::nullopt;
    const Real distance = dot(n, a - ray.origin) / slope;
    const Real t = distance / glm::length(ray.direction);
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = ray.origin + distance * d;
    if (!(dot(cross(b - a, p - a), n) >= 0)) return std::nullopt;
    if (!(dot(cross(c - b, p - b), n) >= 0)) return std::nullopt;
    if (!(dot(cross(a - c, p - c), n) >= 0)) return std::nullopt;
    return t;
}

}  // namespace rt
