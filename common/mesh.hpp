// Triangles that share their vertices, as plain values.
#pragma once

#include "common/real.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rt::inline RT_PRECISION {

struct Mesh {
    std::vector<Vec3> vertices;
    /// One a vertex, of unit length, to be interpolated; none, if the faces are flat.
    std::vector<Vec3> normals;
    /// Three vertices each, anticlockwise for whoever looks from outside.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Where a ray meets a mesh.
struct MeshHit {
    Real t = 0;
    std::uint32_t triangle = 0;
    Vec3 weights;  ///< barycentric, of the triangle's three vertices in their order
};

}  // namespace rt::inline RT_PRECISION
