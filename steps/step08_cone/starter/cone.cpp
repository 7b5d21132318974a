// Stage 8, to be written. docs/step08_cone.md explains it, the header is its contract.
// Begin with intersect. Until normal is written too, hits are magenta: not a number.
// `./course check 8` reports errors, `./course hint 8` prints the next hint.
#include "steps/step08_cone/cone.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    // The smallest t strictly inside the interval at which the ray hits the surface, or nothing.
    RT_TODO(ray, cone, interval);
    return std::nullopt;
}

Vec3 normal(const Cone& cone, Vec3 point) {
    // Away from the axis and, by the slope, back toward the apex, with unit length.
    RT_TODO(cone, point);
    return Vec3(0);
}

}  // namespace rt
