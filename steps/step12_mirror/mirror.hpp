// Stage 12: mirrors (CR §5.1).
//
//   CR                 here
//   d, n               ray.direction, surface.normal
//   R                  mirrored(…).direction
//   NRemainingBounces  depth − bounces
#pragma once

#include "common/geometry/ray.hpp"
#include "common/scene/shading_point.hpp"

namespace rt {

/// The reflected ray, with direction d − 2 n ⟨d, n⟩, which has the length of d. Its origin is off
/// the surface, by surface.error or a little more along surface.geometric_normal. Its direction
/// points away from the surface even if the interpolated normal would reflect it into the surface.
[[nodiscard]] Ray mirrored(const Ray& ray, const ShadingPoint& surface);

/// The color of the reflection, weighted with `mirror`, plus the surface's own color, weighted with
/// the rest.
[[nodiscard]] Color mixed(Color own, Color reflection, Real mirror);

/// Returns whether one more reflection is visible: `bounces` of at most `depth` have been made, and
/// the next one has the given `weight` in the pixel, the product of all mirror strengths so far.
/// Below 1/512, half of one 8-bit level, it is not visible.
[[nodiscard]] bool worth_reflecting(int bounces, int depth, Real weight);

}  // namespace rt
