// The content of a mesh file as OpenMesh reads it, without types of OpenMesh and without Real.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rt {

/// The largest file that is accepted, in bytes.
inline constexpr std::size_t largest_mesh_file = std::size_t(512) << 20;
/// The largest number of corners of a face that is accepted: the time to triangulate it grows with
/// the square of this number.
inline constexpr int most_corners = 4096;

/// Coordinates are float in either precision, because OpenMesh reads no more digits. Both
/// precisions therefore render the same mesh.
struct MeshFile {
    std::vector<glm::vec3> vertices;  ///< all finite
    std::vector<glm::vec3> normals;  ///< one for each vertex, of any length, possibly NaN; or empty
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< at least one
    std::vector<std::string> warnings;  ///< content that is accepted but hardly intended
};

/// Reads the mesh in the file. Throws InputError if the file cannot be read, or a part of it is
/// wrong.
[[nodiscard]] MeshFile read_mesh_file(const std::string& file);

/// Parses the content of a file; the end of its name selects the format. Throws InputError as
/// read_mesh_file does.
[[nodiscard]] MeshFile parse_mesh_file(std::string content, const std::string& file);

}  // namespace rt
