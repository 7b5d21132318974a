// Loading of a mesh file. docs/reference/meshes.md describes the formats.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/system/input_error.hpp"

#include <glm/vec3.hpp>

#include <string>

namespace rt {
inline namespace RT_PRECISION {

/// Loads an OFF, OBJ, PLY or STL file, as the end of its name indicates, with every polygon cut
/// into triangles. Without `smooth` it has no normals. Else they are the file's if it has one for
/// every vertex; of STL those of its facets, smooth but for creases; of an OBJ that is `s off`,
/// those of its faces; else empty (common/geometry/mesh_normals.hpp computes them). Throws
/// InputError if the file is wrong. `warn`, if given, receives a warning for content that is hardly
/// intended.
[[nodiscard]] Mesh load_mesh(const std::string& file, const Warn& warn = nullptr,
                             bool smooth = true);

/// A sentence about coordinates in the box from `low` to `high` that float cannot resolve; empty if
/// there is no such loss.
[[nodiscard]] std::string loss_in_float(glm::dvec3 low, glm::dvec3 high);

/// Warns of triangles whose corners run around the other way than those of their neighbors, and of
/// surfaces with only one side, where that cannot be mended. Call it before the normals are
/// computed. (load_mesh turns the triangles of an STL.)
void warn_of_turned_triangles(const Mesh& mesh, const std::string& file, const Warn& warn);

}  // namespace RT_PRECISION
}  // namespace rt
