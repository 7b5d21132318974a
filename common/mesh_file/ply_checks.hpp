// The declarations of a PLY file that are needed to read its mesh.
#pragma once

#include "common/mesh_file/mesh_builder.hpp"
#include "common/mesh_file/ply_header.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace rt {

/// The properties of a vertex that are read, of which the last three are its normal.
inline constexpr std::array<std::string_view, 6> ply_coordinates = {"x",  "y",  "z",
                                                                    "nx", "ny", "nz"};

/// Returns whether the property is the corners of a face, or of a strip.
[[nodiscard]] inline bool is_corners(const PlyProperty& p) {
    return p.name == "vertex_indices" || p.name == "vertex_index";
}

[[nodiscard]] inline bool has_faces(const PlyElement& element) {
    return element.name == "face" || element.name == "tristrips";
}

/// Renames the only list of whole numbers of a face without vertex_indices so, with a warning: it
/// can be nothing else but its corners.
void name_corners(PlyHeader& header, MeshBuilder& builder);

/// Throws InputError unless there are vertices with a place, and faces or strips with corners.
void check_ply_header(const PlyHeader& header, const std::string& file);

/// Throws InputError for a count that is too large for the bytes after the header of a binary file.
void check_ply_size(const PlyHeader& header, std::uint64_t bytes, const std::string& file);

}  // namespace rt
