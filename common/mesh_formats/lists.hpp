// The common part of OFF and PLY: a list of vertices, then a list of faces.
#pragma once

#include "common/mesh_formats/text.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace rt {

/// The number of vertices and faces, and the words for each.
struct MeshLists {
    std::uint64_t vertices = 0;
    std::size_t words_a_vertex = 3;  ///< 0: as many as the first vertex has
    std::uint64_t faces = 0;
    bool has_normals = false;  ///< normals follow the three coordinates
};

/// Checks the lists of the content, from the current line on. Reports a line with too few or too
/// many words, and a list that ends too early. Overwrites the words after the corners of a face
/// with blanks.
void check_lists(std::string& content, MeshLines& lines, MeshLists& lists);

/// Returns the lists in the form of a binary PLY, in this machine's byte order: three floats for
/// each vertex, or six with normals; for each face an int for the number of corners and one for
/// each corner. Throws InputError as check_lists does, and for a number that a float cannot
/// represent and a vertex that does not exist.
[[nodiscard]] std::string binary_lists(MeshLines& lines, MeshLists& lists);

}  // namespace rt
