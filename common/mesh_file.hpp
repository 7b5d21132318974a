// A mesh as its file has it: what OpenMesh reads, with no OpenMesh in it and no Real.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rt {

/// A file larger than this is refused.
inline constexpr std::size_t largest_mesh_file = std::size_t(512) << 20;
/// A face of more corners is refused: cutting it up takes a time that grows with their square.
inline constexpr int most_corners = 4096;

/// Floats whatever the precision is: OpenMesh reads no more. So both precisions draw the same mesh.
struct MeshFile {
    std::vector<glm::vec3> vertices;  ///< all finite
    std::vector<glm::vec3> normals;   ///< one a vertex, of any length, NaN too; or none at all
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< at least one
    std::vector<std::string> warnings;                    ///< what is read, and is hardly meant so
};

/// The mesh in the file. Throws InputError if there is none, or a part of it is wrong.
[[nodiscard]] MeshFile read_mesh_file(const std::string& file);

/// The mesh in the content of a file of that name, which says how it is to be read.
[[nodiscard]] MeshFile parse_mesh_file(std::string content, const std::string& file);

}  // namespace rt
