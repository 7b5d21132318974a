// right as_printed around intersect: MRT §4 as printed
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Real t = dot(plane.point - ray.origin, plane.normal) / dot(ray.direction, plane.normal);
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt

// right implicit around intersect: a x + b y + c z + d = 0 (PHY)
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Vec3 n = unit(plane.normal);
    const Real d = -dot(n, plane.point);
    const Real approach = dot(n, ray.direction);
    if (approach == 0) return std::nullopt;
    const Real t = -(dot(n, ray.origin) + d) / approach;
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt

// right unit_direction around intersect: along a direction of unit length, and back to the ray's
// own
namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Vec3 n = unit(plane.normal);
    const Real speed = length(ray.direction);
    const Real approach = dot(ray.direction / speed, n);
    if (approach == 0) return std::nullopt;
    const Real t = (dot(plane.point, n) - dot(ray.origin, n)) / approach / speed;
    if (!interval.contains(t)) return std::nullopt;
    return t;
}

}  // namespace rt
