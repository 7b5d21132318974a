// OpenMesh's own readers, called after the checks of each format.
#pragma once

#include "common/mesh_file/openmesh_importer.hpp"

#include <string>

namespace rt {

/// The content of a mesh file, checked, in a form that OpenMesh reads correctly.
struct CheckedMesh {
    std::string content;
    const char* reader = "";  ///< "ply", "obj" or "stl": OpenMesh's reader for it
    bool is_binary = false;
};

/// Calls OpenMesh, which hands the mesh to the importer. Throws InputError, or
/// the importer's MeshRefusal.
void read_checked(CheckedMesh mesh, const std::string& file, MeshImporter& importer);

}  // namespace rt
