#include "common/mesh_file/checked_mesh.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/mesh_file/open_mesh.hpp"
#include "common/system/escaping.hpp"
#include "common/system/lower_case.hpp"

#include <utility>

namespace rt {

namespace {

/// The layout of a binary file: 80 arbitrary bytes, the number of triangles, then 50 bytes for
/// each: twelve floats and two bytes more.
constexpr std::size_t header_size = 84;
constexpr std::size_t triangle_size = 50;

std::uint64_t byte(const std::string& content, std::size_t at) {
    return static_cast<unsigned char>(content[at]);
}

std::uint64_t triangle_count(const std::string& content) {
    return byte(content, 80) | byte(content, 81) << 8 | byte(content, 82) << 16 |
           byte(content, 83) << 24;
}

/// Throws InputError for NaN and infinity, which OpenMesh would look up in a sorted map: all ones
/// in the exponent of a little-endian float. The first three floats are the face's normal, which is
/// not used.
void check_numbers(const std::string& content, const std::string& file) {
    for (std::size_t at = header_size; at < content.size(); at += triangle_size) {
        for (std::size_t i = 3; i < 12; ++i) {
            const std::size_t high = at + 4 * i + 3;
            if ((byte(content, high) & 0x7f) != 0x7f || byte(content, high - 1) < 0x80) continue;
            throw InputError({file}, "triangle " +
                                         std::to_string((at - header_size) / triangle_size) +
                                         " has a corner that is not a place");
        }
    }
}

/// "solid", in any case, perhaps after three blanks.
bool begins_as_text(const std::string& content) {
    const std::string begin = lower_case(content.substr(0, 8));
    return begin.starts_with("solid") || begin.starts_with("   solid");
}

/// Calls OpenMesh, which leaves out the triangles that have two corners in one place in silence.
void read_triangles(CheckedMesh mesh, std::size_t triangles, const std::string& file,
                    MeshImporter& importer) {
    read_checked(std::move(mesh), file, importer);
    importer.leave_out_faces(triangles - importer.n_faces());
}

/// Reads a text file. Checks it first, and allows only the lines that OpenMesh recognizes: it
/// searches for "outer" anywhere, even in the name of the solid, and parses the next three lines as
/// vertices.
void read_text(std::string content, const std::string& file, MeshImporter& importer) {
    plain_text(content);
    MeshLines lines(content, file);
    CheckedMesh checked = {.reader = "stl"};
    std::size_t triangles = 0;
    int corners_to_come = 0;
    std::string keyword;
    while (const auto line = lines.next()) {
        std::string_view rest = *line;
        keyword = lower_case(std::string(take_word(rest).substr(0, 16)));
        if ((corners_to_come > 0) != (keyword == "vertex")) {
            lines.refuse(
                std::string("expected ") +
                (corners_to_come > 0 ? "\"vertex x y z\"" : "\"facet\" or \"outer loop\"") +
                " at the start of a line, not " + quoted(*line));
        }
        if (keyword == "outer") {
            checked.content += "outer\n";
            corners_to_come = 3;
            ++triangles;
        } else if (keyword == "vertex") {
            require_three_numbers(rest, "a vertex", lines);
            require_no_word(rest, "a vertex", lines);
            checked.content.append(*line).append("\n");
            --corners_to_come;
        }
    }
    if (keyword != "endsolid")
        lines.refuse("the file ends before its \"endsolid\" at the start of a line");
    read_triangles(std::move(checked), triangles, file, importer);
}

}  // namespace

void read_stl(std::string content, const std::string& file, MeshImporter& importer) {
    // The same criterion as OpenMesh's: a binary file may start with "solid" too.
    const bool has_header = content.size() >= header_size;
    const std::uint64_t count = has_header ? triangle_count(content) : 0;
    if (has_header && content.size() == header_size + count * triangle_size) {
        check_numbers(content, file);
        read_triangles({.content = std::move(content), .reader = "stl", .is_binary = true}, count,
                       file, importer);
        return;
    }
    blank_byte_order_mark(content);
    if (begins_as_text(content)) {
        read_text(std::move(content), file, importer);
        return;
    }
    if (!has_header) throw InputError({file}, "is not STL: expected \"solid\" or a binary header");
    throw InputError({file}, "a binary STL of " + std::to_string(count) + " triangles has " +
                                 std::to_string(header_size + count * triangle_size) +
                                 " bytes, not " + std::to_string(content.size()));
}

}  // namespace rt
