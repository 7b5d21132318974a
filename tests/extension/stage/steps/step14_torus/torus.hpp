// Stage 14: tori. No course document has them.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/geometry/torus.hpp"

#include <optional>

namespace rt {

/// The smallest t strictly inside the interval at which the ray hits the torus, from outside or
/// from inside of its tube. Returns nothing if there is none, or if a coordinate is NaN.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Torus& torus, Interval interval);

/// The unit normal at a point of the surface, away from the circle in the tube.
[[nodiscard]] Vec3 normal(const Torus& torus, Vec3 point);

}  // namespace rt
