// A reader for each mesh format. OpenMesh's own readers are not used: they round to float, invent
// values for numbers that they cannot parse, believe any count, remove corners that a face visits
// twice, and open the files that an OBJ names.
#pragma once

#include "common/mesh_file/mesh_builder.hpp"

#include <string>

namespace rt {

// Each function adds the vertices and faces of the content to the builder. Throws InputError, in a
// text with the line of the error, or MeshRefusal. The content may be modified.

/// Reads an OFF file as text, with the letters N, C and ST before the keyword in any order, or
/// without a keyword. A vertex is on a line of its own, a face may continue on the next. Colors and
/// texture coordinates are skipped.
void read_off(std::string& content, const std::string& file, MeshBuilder& builder);

/// Reads an OBJ file: lines v, vn and f; other lines are skipped.
void read_obj(std::string& content, const std::string& file, MeshBuilder& builder);

/// Reads a PLY file, text or binary of either byte order: positions and normals of the element
/// vertex, corners of the elements face and tristrips, in any order; the rest is skipped.
void read_ply(std::string& content, const std::string& file, MeshBuilder& builder);

/// Reads an STL file, text or binary. Corners in the same place become one vertex.
void read_stl(std::string& content, const std::string& file, MeshBuilder& builder);

}  // namespace rt
