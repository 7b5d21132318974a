// What GLM leaves open about vectors.
#pragma once

#include "common/real.hpp"

#include <cmath>

namespace rt {

/// v made unit length, to 4 u, for any non-zero finite v: the largest component is divided out
/// first, so that no square over- or underflows. Every component of a zero v comes back NaN.
[[nodiscard]] inline Vec3 unit(Vec3 v) {
    const Vec3 size = glm::abs(v);
    const Vec3 scaled = v / glm::max(size.x, glm::max(size.y, size.z));
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// The normal turned to the side that the direction comes from. Shading wants it; shapes give
/// outward normals.
[[nodiscard]] inline Vec3 facing(Vec3 normal, Vec3 direction) {
    return glm::dot(normal, direction) > 0 ? -normal : normal;
}

}  // namespace rt
