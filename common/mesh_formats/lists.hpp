// What OFF and PLY have in common: a list of vertices, then one of faces.
#pragma once

#include "common/mesh_formats/text.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace rt {

/// How many there are, and how many words stand for each.
struct MeshLists {
    std::uint64_t vertices = 0;
    std::size_t words_a_vertex = 3;  ///< 0: as many as the first has
    std::uint64_t faces = 0;
    bool has_normals = false;  ///< after the three coordinates
};

/// Goes through the lists of the content, from where the lines are. Refuses a line with too few or
/// too many words, and a list that ends too early. Overwrites with blanks what follows the corners
/// of a face.
void check_lists(std::string& content, MeshLines& lines, MeshLists& lists);

/// The lists as a binary PLY has them, in this machine's order of bytes: three floats a vertex, or
/// six if there are normals after all; an int for the number of corners and one for each. Refuses
/// what check_lists does, a number that a float does not hold, and a vertex that is not there.
[[nodiscard]] std::string binary_lists(MeshLines& lines, MeshLists& lists);

}  // namespace rt
