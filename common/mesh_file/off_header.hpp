// The first lines of an OFF file: the letters before OFF, and the counts.
#pragma once

#include "common/mesh_file/mesh_lines.hpp"

#include <cstdint>

namespace rt {

struct OffHeader {
    bool has_normals = false;
    bool colors_first = false;  ///< N before C, as MeshLab writes, and then colors before normals
    bool has_texture = false;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
};

/// Reads the header, which may be without a keyword. Throws InputError for a variant that is not
/// read.
[[nodiscard]] OffHeader take_off_header(MeshLines& lines);

}  // namespace rt
