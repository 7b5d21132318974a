// Stage 4, to be written: docs/step04_plane.md.
#include "steps/step04_plane/plane.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    // The t strictly inside the interval at which the ray crosses the plane, or nothing.
    RT_TODO(ray, plane, interval);
    return std::nullopt;
}

Vec3 normal(const Plane& plane, Vec3 point) {
    // The plane's normal, with unit length, at every point.
    RT_TODO(plane, point);
    return Vec3(0);
}

}  // namespace rt
