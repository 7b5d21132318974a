// Normals for meshes whose file has none.
#pragma once

#include "common/mesh.hpp"

#include <vector>

namespace rt {

/// One unit normal a vertex: the mean of the normals of its triangles, each weighted by its angle
/// there, so that it does not matter how a face was cut (Thürmer, Wüthrich 1998). (0, 0, 1) where
/// there is none: at a vertex of no triangle, or of triangles without an area.
[[nodiscard]] std::vector<Vec3> smooth_normals(const Mesh& mesh);

}  // namespace rt
