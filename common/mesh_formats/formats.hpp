// What each format is checked for before OpenMesh reads it. OpenMesh 9 trusts its input: it makes
// up numbers that it cannot read, believes any count, ends the program at "f /1", opens the files
// that an OBJ names, and never leaves a PLY header without an end. So a file is first gone through
// line by line, and put into the form that OpenMesh reads right.
#pragma once

#include <cstddef>
#include <string>

namespace rt {

/// A mesh that is checked but for the numbers that OpenMesh's stream refuses itself.
struct CheckedMesh {
    std::string content;
    const char* reader = "";  ///< "ply", "obj" or "stl": OpenMesh's reader for it
    bool is_binary = false;
    /// Where in the content the file's own text goes on after a header of ours, and on which line.
    std::size_t body = 0;
    int body_line = 1;
    /// Faces of fewer than three different vertices that OpenMesh leaves out in silence.
    std::size_t faces_without_area = 0;
};

// Each throws InputError with the line of what is wrong.

/// [ST][C][N]OFF as text, one vertex or face a line; colours and texture coordinates are left out.
/// It becomes a binary PLY: OpenMesh's OFF reader takes the colour of a face for the next face, and
/// over the digits of a million triangles its streams take 0.16 s more.
[[nodiscard]] CheckedMesh checked_off(std::string content, const std::string& file);

/// Lines v, vn and f; the others are left out.
[[nodiscard]] CheckedMesh checked_obj(std::string content, const std::string& file);

/// Text or binary of either byte order; of the properties, positions, normals and corners are kept.
[[nodiscard]] CheckedMesh checked_ply(std::string content, const std::string& file);

/// Text or binary.
[[nodiscard]] CheckedMesh checked_stl(std::string content, const std::string& file);

}  // namespace rt
