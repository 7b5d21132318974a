// Stage 7, to be written. docs/step07_cylinder.md explains it, the header is its contract.
// Begin with intersect. Until normal is written too, hits are magenta: not a number.
// `./course check 7` reports errors, `./course hint 7` prints the next hint.
#include "steps/step07_cylinder/cylinder.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    // The smallest t strictly inside the interval at which the ray hits the surface, or nothing.
    RT_TODO(ray, cylinder, interval);
    return std::nullopt;
}

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    // Away from the axis, with unit length.
    RT_TODO(cylinder, point);
    return Vec3(0);
}

}  // namespace rt
