// Stage 8, to be written: docs/step08_cone.md says how, the header what is promised.
// Begin with intersect. Until normal is written too, what it meets is drawn in magenta: no number.
// `./course check 8` says what is wrong, `./course hint 8` what to think of next.
#include "steps/step08_cone/cone.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    // The smallest t strictly inside the interval at which the ray meets the side, or nothing.
    RT_TODO(ray, cone, interval);
    return std::nullopt;
}

Vec3 normal(const Cone& cone, Vec3 point) {
    // Away from the axis and, by the slope, back towards the apex, with unit length.
    RT_TODO(cone, point);
    return Vec3(0);
}

}  // namespace rt
