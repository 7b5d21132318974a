// Stage 12: mirrors (CR §5.1).
//
//   CR                 here
//   d, n               ray.direction, surface.normal
//   R                  mirrored(…).direction
//   NRemainingBounces  depth − bounces
#pragma once

#include "common/ray.hpp"
#include "common/surface.hpp"

namespace rt {

/// The ray that the mirror sends on: d − 2 n ⟨d, n⟩, as long as d, from off the surface by
/// surface.error or a little more on surface.side, and away from it even if the normal is
/// interpolated and would send it in.
[[nodiscard]] Ray mirrored(const Ray& ray, const Surface& surface);

/// The mirror's share of what is reflected, and the rest of what the surface shows of the lights.
[[nodiscard]] Color mixed(Color own, Color reflection, Real mirror);

/// Whether one more reflection can be seen: `bounces` have been made of at most `depth`, and the
/// next would count in the pixel by `weight`, the product of all shares so far. Below 1/512, half a
/// step of the picture's 256, it would not show.
[[nodiscard]] bool worth_reflecting(int bounces, int depth, Real weight);

}  // namespace rt
