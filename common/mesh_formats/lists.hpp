// What OFF and the text form of PLY have in common: a list of vertices, then one of faces.
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
};

/// Goes through the lists of the content, from where the lines are. Refuses a line with too few or
/// too many words, and a list that ends too early. Overwrites with blanks what follows the corners
/// of a face.
void check_lists(std::string& content, MeshLines& lines, MeshLists& lists);

}  // namespace rt
