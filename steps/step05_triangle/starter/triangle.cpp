// Stage 5, to be written: docs/step05_triangle.md says how, the header what is promised.
// Begin with intersect, by any of the page's three ways. Until normal is written too, what it meets
// is drawn in magenta: no number. barycentric is first drawn with in stage 13.
// `./course check 5` says what is wrong, `./course hint 5` what to think of next.
#include "steps/step05_triangle/triangle.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    // The t strictly inside the interval at which the ray meets the triangle, or nothing.
    RT_TODO(ray, triangle, interval);
    return std::nullopt;
}

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    // The weights of a, b and c that give the point.
    RT_TODO(triangle, point);
    return Vec3(0);
}

Vec3 normal(const Triangle& triangle, Vec3 /*point*/) {
    // Along (b − a) × (c − a), with unit length.
    RT_TODO(triangle);
    return Vec3(0);
}

}  // namespace rt
