// A triangle mesh with shared vertices, as plain values.
#pragma once

#include "common/math/real.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

struct Mesh {
    std::vector<Vec3> vertices;
    /// One unit normal for each vertex, to be interpolated; empty if the faces are flat.
    std::vector<Vec3> normals;
    /// Three vertex indices for each triangle, counterclockwise seen from outside.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct MeshHit {
    Real t = 0;
    std::uint32_t triangle = 0;
    Vec3 weights;  ///< barycentric coordinates, in the order of the triangle's three vertices
};

}  // namespace RT_PRECISION
}  // namespace rt
