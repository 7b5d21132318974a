// A reader for each mesh format. OFF and PLY as text are handed to the importer word by word. OBJ,
// STL and binary PLY are checked first, and then OpenMesh reads them. OpenMesh 9 trusts its input:
// it invents values for numbers that it cannot parse, believes any count, aborts the program at "f
// /1", opens the files that an OBJ names, and never returns from a PLY header without an end.
#pragma once

#include "common/mesh_file/openmesh_importer.hpp"

#include <string>

namespace rt {

// Each function hands the vertices and faces of the content to the importer. Throws InputError, in
// a text with the line of the error.

/// Reads an [ST][C][N]OFF file: text, one vertex or face on each line; colors and texture
/// coordinates are skipped. OpenMesh's own OFF reader uses the color of a face for the next face.
void read_off(std::string content, const std::string& file, MeshImporter& importer);

/// Reads an OBJ file: lines v, vn and f; other lines are skipped.
void read_obj(std::string content, const std::string& file, MeshImporter& importer);

/// Reads a PLY file, text or binary of either byte order. Positions, normals and corners are kept,
/// and other properties skipped.
void read_ply(std::string content, const std::string& file, MeshImporter& importer);

/// Reads an STL file, text or binary.
void read_stl(std::string content, const std::string& file, MeshImporter& importer);

}  // namespace rt
