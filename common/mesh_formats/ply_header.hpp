// What a PLY file says of itself before its numbers.
#pragma once

#include "common/mesh_formats/text.hpp"

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
};

struct PlyProperty {
    PlyType type;
    std::string name;
    /// Of a list: what its length is written in.
    std::optional<PlyType> length;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    int line = 0;
};

struct PlyHeader {
    std::string format;
    std::vector<PlyElement> elements;
};

/// The header, to the line end_header and with it. Refuses a line that is none of a header.
[[nodiscard]] PlyHeader take_ply_header(MeshLines& lines);

}  // namespace rt
