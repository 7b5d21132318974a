// The content of a mesh file, without Real.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// The largest file that is accepted, in bytes.
inline constexpr std::size_t largest_mesh_file = std::size_t(512) << 20;
/// The largest number of corners of a face that is accepted: the time to triangulate it grows with
/// the square of this number.
inline constexpr int most_corners = 4096;

/// Content that is accepted but hardly intended.
struct MeshWarning {
    std::string text;
    int line = 0;             ///< 0 if it has none
    bool of_normals = false;  ///< which flat shading does not use
};

struct MeshFile {
    std::vector<glm::dvec3> vertices;  ///< all in the range of float
    std::vector<glm::dvec3> normals;   ///< one for each vertex, of any length, 0 included; or empty
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< at least one
    std::vector<MeshWarning> warnings;
    bool facets = false;  ///< the file has no shared vertices: this reader joined its corners
    /// The angle between faces beyond which an edge is sharp, in radians; nothing if none is.
    std::optional<double> crease;
};

/// Reads the mesh in the file. Throws InputError if the file cannot be read, or a part of it is
/// wrong.
[[nodiscard]] MeshFile read_mesh_file(const std::string& file);

/// Parses the content of a file; the end of its name selects the format. Throws InputError as
/// read_mesh_file does.
[[nodiscard]] MeshFile parse_mesh_file(std::string content, const std::string& file);

}  // namespace rt
