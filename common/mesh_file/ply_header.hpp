// The header of a PLY file.
#pragma once

#include "common/mesh_file/mesh_lines.hpp"

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

}  // namespace rt
