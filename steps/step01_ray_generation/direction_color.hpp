// The color of a ray where there is nothing to see yet: its direction.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/math/vector.hpp"

namespace rt {

/// The direction, of any length, as a color: red grows to the right, green upwards.
[[nodiscard]] inline Color direction_color(const Ray& ray) {
    return (unit(ray.direction) + Real(1)) / Real(2);
}

}  // namespace rt
