// Stage 7, to be written: docs/step07_cylinder.md.
#include "steps/step07_cylinder/cylinder.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

#include <cmath>

namespace rt {

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
