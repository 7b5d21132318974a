// Polygons of any number of corners, cut into triangles.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// The triangles, as places in `corners`, that together cover the polygon and turn as it does: n −
/// 2 of them, none for fewer than three corners. A polygon that is not flat, crosses itself or has
/// no area is cut somehow, into as many. Takes a time that grows with n², in the worst case.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(
    std::span<const glm::dvec3> corners);

}  // namespace rt
