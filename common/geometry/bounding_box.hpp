// Axis-aligned bounding boxes (M1, "boite alignée sur les axes").
#pragma once

#include "common/math/vector.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// All points from corner `min` to corner `max`; empty if a component of min is greater than that
/// of max.
struct BoundingBox {
    Vec3 min{infinity};
    Vec3 max{-infinity};
};

}  // namespace RT_PRECISION

/// The largest absolute value of a coordinate in the box.
[[nodiscard]] inline Real largest_component(const BoundingBox& box) {
    return glm::max(largest_component(box.min), largest_component(box.max));
}

/// The smallest box that contains both boxes.
[[nodiscard]] inline BoundingBox merged(const BoundingBox& a, const BoundingBox& b) {
    return {.min = glm::min(a.min, b.min), .max = glm::max(a.max, b.max)};
}

/// The smallest box that contains the box and the point.
[[nodiscard]] inline BoundingBox merged(const BoundingBox& box, Vec3 point) {
    return {.min = glm::min(box.min, point), .max = glm::max(box.max, point)};
}

}  // namespace rt
