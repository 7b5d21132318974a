// Stage 4, to be written. docs/step04_plane.md explains it, the header is its contract.
// Begin with intersect. Until normal is written too, hits are magenta: not a number.
// `./course check 4` reports errors, `./course hint 4` prints the next hint.
#include "steps/step04_plane/plane.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    // The t strictly inside the interval at which the ray hits the plane, or nothing.
    RT_TODO(ray, plane, interval);
    return std::nullopt;
}

Vec3 normal(const Plane& plane, Vec3 /*point*/) {
    // The plane's normal, with unit length, at every point.
    RT_TODO(plane);
    return Vec3(0);
}

}  // namespace rt
