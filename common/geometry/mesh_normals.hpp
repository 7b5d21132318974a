// Vertex normals for meshes whose file has none.
#pragma once

#include "common/geometry/mesh.hpp"

namespace rt {

/// Gives each vertex a unit normal: the mean of the normals of its triangles, each weighted by the
/// triangle's angle at the vertex, so that the triangulation of a face does not matter (Thürmer,
/// Wüthrich 1998). Where this mean nearly cancels, as in a sheet whose faces are all there twice,
/// front and back, the vertex gets a copy at the end of the list: one for each side. The normal of
/// a vertex of no triangle, or only of triangles without area, is (0, 0, 1).
void add_smooth_normals(Mesh& mesh);

/// The same, but edges whose faces meet at a larger angle than this one stay sharp, and their
/// vertices get copies. The angle is that between the normals of the faces, in radians.
void add_creased_normals(Mesh& mesh, double angle);

/// Turns each triangle over whose corners are clockwise, seen from the side of its normals: the
/// normals decide. Shading needs both on the same side.
void turn_to_normals(Mesh& mesh);

}  // namespace rt
