// Checks of each mesh format before OpenMesh reads the file. OpenMesh 9 trusts its input: it
// invents values for numbers that it cannot parse, believes any count, aborts the program at "f
// /1", opens the files that an OBJ names, and never returns from a PLY header without an end.
// Therefore a file is first checked line by line, and converted to a form that OpenMesh reads
// correctly.
#pragma once

#include <cstddef>
#include <string>

namespace rt {

/// The content of a mesh file, checked except for numbers that OpenMesh's stream rejects itself.
struct CheckedMesh {
    std::string content;
    const char* reader = "";  ///< "ply", "obj" or "stl": OpenMesh's reader for it
    bool is_binary = false;
    /// Offset in the content at which the file's own text continues after a generated header, and
    /// its line number.
    std::size_t body = 0;
    int body_line = 1;
    /// The number of faces with fewer than three different vertices, which OpenMesh skips silently.
    std::size_t faces_without_area = 0;
};

// Each function throws InputError with the line of the error.

/// Checks an [ST][C][N]OFF file: text, one vertex or face on each line; colors and texture
/// coordinates are skipped. The result is a binary PLY: OpenMesh's OFF reader uses the color of a
/// face for the next face, and its streams take 0.16 s longer to parse the digits of a million
/// triangles.
[[nodiscard]] CheckedMesh checked_off(std::string content, const std::string& file);

/// Checks an OBJ file: lines v, vn and f; other lines are skipped.
[[nodiscard]] CheckedMesh checked_obj(std::string content, const std::string& file);

/// Checks a PLY file, text or binary of either byte order. Of its properties, positions, normals
/// and corners are kept.
[[nodiscard]] CheckedMesh checked_ply(std::string content, const std::string& file);

/// Checks an STL file, text or binary.
[[nodiscard]] CheckedMesh checked_stl(std::string content, const std::string& file);

}  // namespace rt
