// Stage 5, to be written. docs/step05_triangle.md explains it, the header is its contract.
// Begin with intersect, by any of the three methods on the page. Until normal is written too, hits
// are magenta: not a number. barycentric first affects the picture in stage 13.
// `./course check 5` reports errors, `./course hint 5` prints the next hint.
#include "steps/step05_triangle/triangle.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    // The t strictly inside the interval at which the ray hits the triangle, or nothing.
    RT_TODO(ray, triangle, interval);
    return std::nullopt;
}

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    // The barycentric coordinates of the point: the weights of a, b and c.
    RT_TODO(triangle, point);
    return Vec3(0);
}

Vec3 normal(const Triangle& triangle, Vec3 /*point*/) {
    // Along (b − a) × (c − a), with unit length.
    RT_TODO(triangle);
    return Vec3(0);
}

}  // namespace rt
