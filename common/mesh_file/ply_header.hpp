// The header of a PLY file.
#pragma once

#include "common/mesh_file/mesh_builder.hpp"
#include "common/mesh_file/mesh_lines.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// "float", of four bytes, …
struct PlyType {
    std::string_view name;
    std::size_t size = 0;
    bool is_float = false;
    bool is_signed = true;
};

/// A property of an element: its type and name, and the line that declares it.
struct PlyProperty {
    PlyType type;
    std::string name;
    /// For a list: the type of its length.
    std::optional<PlyType> length;
    int line = 0;
};

/// An element, such as vertex or face: its number and properties, and the line that declares it.
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    int line = 0;
};

/// A parsed header.
struct PlyHeader {
    std::string format;
    std::vector<PlyElement> elements;
};

/// Parses the header, up to and including the line end_header. Throws InputError at a line that
/// does not belong in a header.
[[nodiscard]] PlyHeader take_ply_header(MeshLines& lines);

// The declarations of a PLY file that are needed to read its mesh.

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

/// "vertices"
[[nodiscard]] std::string items_of(const PlyElement& element);

/// Renames the only list of whole numbers of a face without vertex_indices so, with a warning: it
/// can be nothing else but its corners.
void name_corners(PlyHeader& header, MeshBuilder& builder);

/// Throws InputError unless there are vertices with a place, and faces or strips with corners.
void check_ply_header(const PlyHeader& header, const std::string& file);

/// Throws InputError for a count that is too large for the bytes after the header of a binary file.
void check_ply_size(const PlyHeader& header, std::uint64_t bytes, const std::string& file);

}  // namespace rt
