// Stage 4, to be written: docs/step04_plane.md says how, the header what is promised.
// Begin with intersect. Until normal is written too, what it meets is drawn in magenta: no number.
// `./course check 4` says what is wrong, `./course hint 4` what to think of next.
#include "steps/step04_plane/plane.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    // The t strictly inside the interval at which the ray crosses the plane, or nothing.
    RT_TODO(ray, plane, interval);
    return std::nullopt;
}

Vec3 normal(const Plane& plane, Vec3 /*point*/) {
    // The plane's normal, with unit length, at every point.
    RT_TODO(plane);
    return Vec3(0);
}

}  // namespace rt
