// right by_uv around intersect: HAI's u and v from the corner
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 n = square.basis.z;
    if (square.one_sided && dot(ray.direction, n) >= 0) return std::nullopt;
    const Real t = -dot(n, ray.origin - square.center) / dot(n, ray.direction);
    if (!interval.contains(t)) return std::nullopt;
    const Vec2 uv = square_uv(square, at(ray, t));
    if (!(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1)) return std::nullopt;
    return t;
}

}  // namespace rt

// right edge_tests around intersect: CR §2.3, edge by edge, with ≥
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

// right own_basis around intersect: MRT §6 as printed, with ≤, and abs without std::
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Real approach = dot(ray.direction, square.basis.z);
    if (square.one_sided && approach >= 0) return std::nullopt;
    const Real t = dot(square.center - ray.origin, square.basis.z) / approach;
    if (!interval.contains(t)) return std::nullopt;
    const Vec3 p = at(ray, t) - square.center;
    if (!(abs(dot(p, square.basis.x)) <= square.side / 2)) return std::nullopt;
    if (!(abs(dot(p, square.basis.y)) <= square.side / 2)) return std::nullopt;
    return t;
}

}  // namespace rt

// right side_of_the_origin around intersect: a one-sided square is seen from its front if the ray
// starts there
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const auto& [x, y, z] = square.basis;
    const Vec3 o = ray.origin - square.center;
    if (square.one_sided && !(dot(o, z) > 0)) return std::nullopt;
    const Real t = -dot(o, z) / dot(ray.direction, z);
    const Vec3 p = o + t * ray.direction;
    const bool inside =
        std::abs(dot(p, x)) <= square.side / 2 && std::abs(dot(p, y)) <= square.side / 2;
    return inside && interval.contains(t) ? std::optional(t) : std::nullopt;
}

}  // namespace rt

// right unit_direction around intersect: a unit direction, and half a side from the center
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
