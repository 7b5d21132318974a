// Stage 7, to be written: docs/step07_cylinder.md says how, the header what is promised.
// Begin with intersect. Until normal is written too, what it meets is drawn in magenta: no number.
// `./course check 7` says what is wrong, `./course hint 7` what to think of next.
#include "steps/step07_cylinder/cylinder.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    // The smallest t strictly inside the interval at which the ray meets the side, or nothing.
    RT_TODO(ray, cylinder, interval);
    return std::nullopt;
}

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    // Away from the axis, with unit length.
    RT_TODO(cylinder, point);
    return Vec3(0);
}

}  // namespace rt
