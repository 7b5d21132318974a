// Reads a mesh. docs/meshes.md says what from.
#pragma once

#include "common/input_error.hpp"
#include "common/mesh.hpp"

#include <string>

namespace rt::inline RT_PRECISION {

/// The mesh in the file, OFF, OBJ, PLY or STL as its name ends, with every polygon cut into
/// triangles. Its normals are the file's if that has one for every vertex, else there are none
/// (common/mesh_normals.hpp makes them). Throws InputError for all else. One thread at a time:
/// OpenMesh's readers share what they know of a file.
/// With `warn`, it is told what is hardly meant so.
[[nodiscard]] Mesh load_mesh(const std::string& file, const Warn& warn = nullptr);

}  // namespace rt::inline RT_PRECISION
