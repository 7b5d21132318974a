// The common part of OFF and PLY as text: a list of vertices, then a list of faces.
#pragma once

#include "common/mesh_file/mesh_lines.hpp"
#include "common/mesh_file/openmesh_importer.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt {

struct MeshLists {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::size_t words_a_vertex = 0;  ///< 0: as many as the first vertex has
    /// The meaning of each word of a vertex: 0 to 2 are x, y and z, 3 to 5 those of its normal, −1
    /// is skipped, and so are further words. If a vertex has fewer words, it has no normal.
    std::vector<int> columns;
};

/// Hands the lists to the importer, from the current line on: one vertex or face on each line. The
/// words after the corners of a face are skipped. Throws InputError for a line with too few or too
/// many words, a list that ends too early, a number that a float cannot represent, and a vertex
/// that does not exist.
void read_lists(MeshLines& lines, MeshLists lists, MeshImporter& importer);

}  // namespace rt
