// Vertex normals for meshes whose file has none.
#pragma once

#include "common/geometry/mesh.hpp"

#include <vector>

namespace rt {

/// Returns one unit normal for each vertex: the mean of the normals of its triangles, each weighted
/// by the triangle's angle at the vertex, so that the triangulation of a face does not matter
/// (Thürmer, Wüthrich 1998). Returns (0, 0, 1) for a vertex of no triangle, or only of triangles
/// without area.
[[nodiscard]] std::vector<Vec3> smooth_normals(const Mesh& mesh);

}  // namespace rt
