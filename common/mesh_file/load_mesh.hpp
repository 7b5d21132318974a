// Loading of a mesh file. docs/reference/meshes.md describes the formats.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/system/input_error.hpp"

#include <string>

namespace rt {
inline namespace RT_PRECISION {

/// Loads an OFF, OBJ, PLY or STL file, as the end of its name indicates, with every polygon cut
/// into triangles. The normals are the file's if it has one for every vertex, else empty
/// (common/geometry/mesh_normals.hpp computes them). Throws InputError if the file is wrong. Call
/// it from one thread at a time: OpenMesh's readers share state. `warn`, if given, receives a
/// warning for content that is hardly intended.
[[nodiscard]] Mesh load_mesh(const std::string& file, const Warn& warn = nullptr);

}  // namespace RT_PRECISION
}  // namespace rt
