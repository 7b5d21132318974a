// Triangulation of polygons with any number of corners.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// Returns n − 2 triangles, as indices in `corners`, that cover the polygon and have its
/// orientation; empty for fewer than three corners. A polygon that is not planar, intersects itself
/// or has no area gets n − 2 triangles too, without further guarantees. The worst-case time is
/// proportional to n².
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(
    std::span<const glm::dvec3> corners);

}  // namespace rt
