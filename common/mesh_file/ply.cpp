#include "common/mesh_file/checked_mesh.hpp"
#include "common/mesh_file/element_lists.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/mesh_file/open_mesh.hpp"
#include "common/mesh_file/ply_header.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace rt {

namespace {

std::ptrdiff_t count_of(const PlyElement& element, std::string_view property) {
    return std::count_if(element.properties.begin(), element.properties.end(),
                         [=](const PlyProperty& p) { return p.name == property; });
}

bool is_coordinate(std::string_view name) {
    return name == "x" || name == "y" || name == "z";
}

bool is_of_normal(std::string_view name) {
    return name == "nx" || name == "ny" || name == "nz";
}

void check_vertex(const PlyElement& vertex, const std::string& file) {
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
        const std::ptrdiff_t count = count_of(vertex, name);
        if (count == 1 || (count == 0 && is_of_normal(name))) continue;
        throw InputError({file, vertex.line}, "a vertex has " + std::to_string(count) +
                                                  " properties " + name + ": expected one");
    }
    for (const PlyProperty& p : vertex.properties) {
        if (p.length) {
            throw InputError({file, vertex.line}, "a vertex has a list: expected numbers only");
        }
        if (p.type.is_float || (!is_coordinate(p.name) && !is_of_normal(p.name))) continue;
        throw InputError({file, vertex.line},
                         "a vertex's " + p.name + " must be a float or a double");
    }
}

void check_face(const PlyElement& face, const std::string& file) {
    bool is_right = !face.properties.empty();
    for (std::size_t i = 0; i < face.properties.size(); ++i) {
        const PlyProperty& p = face.properties[i];
        const bool is_corners = p.name == "vertex_indices" || p.name == "vertex_index";
        const bool has_integers = !p.type.is_float && p.length && !p.length->is_float;
        is_right = is_right && (i == 0 ? is_corners && has_integers : !p.length);
    }
    if (is_right) return;
    throw InputError(
        {file, face.line},
        "a face must have one list, vertex_indices of whole numbers, as its first property");
}

/// Throws InputError for a header that OpenMesh would misread.
void check_header(const PlyHeader& header, const std::string& file) {
    if (header.format != "ascii" && header.format != "binary_little_endian" &&
        header.format != "binary_big_endian") {
        throw InputError({file},
                         "expected the format ascii, binary_little_endian or binary_big_endian, "
                         "not " +
                             rt::quoted(header.format));
    }
    const auto& elements = header.elements;
    if (elements.size() < 2 || elements[0].name != "vertex" || elements[1].name != "face") {
        throw InputError({file}, "expected the elements vertex and face, first and in this order");
    }
    check_vertex(elements[0], file);
    check_face(elements[1], file);
}

bool has_normals(const PlyElement& vertex) {
    return count_of(vertex, "nx") + count_of(vertex, "ny") + count_of(vertex, "nz") == 3;
}

/// The header of a binary file in a form that OpenMesh reads correctly; properties to skip are
/// named
/// "_".
std::string plain_header(const PlyHeader& header) {
    const PlyElement& vertex = header.elements[0];
    const PlyElement& face = header.elements[1];
    const bool with_normals = has_normals(vertex);
    std::string text = "ply\nformat " + header.format + " 1.0\nelement vertex " +
                       std::to_string(vertex.count) + "\n";
    for (const PlyProperty& p : vertex.properties) {
        const bool is_read = is_coordinate(p.name) || (with_normals && is_of_normal(p.name));
        text.append("property ").append(p.type.name).append(" ");
        text.append(is_read ? p.name : "_").append("\n");
    }
    // OpenMesh knows only one type of each size for a length.
    const std::size_t size = face.properties[0].length->size;
    text += "element face " + std::to_string(face.count) + "\nproperty list ";
    text += size == 1 ? "uint8 " : size == 2 ? "uint16 " : "int ";
    text.append(face.properties[0].type.name).append(" vertex_indices\n");
    for (std::size_t i = 1; i < face.properties.size(); ++i) {
        text.append("property ").append(face.properties[i].type.name).append(" _\n");
    }
    return text + "end_header\n";
}

/// The meaning of each word of a vertex, as in MeshLists.
std::vector<int> columns_of(const PlyElement& vertex) {
    constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};
    const auto end = has_normals(vertex) ? names.end() : names.begin() + 3;
    std::vector<int> columns;
    for (const PlyProperty& p : vertex.properties) {
        const auto found = std::find(names.begin(), end, p.name);
        columns.push_back(found == end ? -1 : int(found - names.begin()));
    }
    return columns;
}

/// Throws InputError for a count that is too large for the bytes after the header, before memory is
/// allocated for it.
void check_size(const PlyHeader& header, std::uint64_t bytes, const std::string& file) {
    for (std::size_t i = 0; i < 2; ++i) {
        const PlyElement& element = header.elements[i];
        std::uint64_t least = 0;
        for (const PlyProperty& p : element.properties) {
            least += p.length ? p.length->size : p.type.size;
        }
        if (element.count > bytes / least) {
            throw InputError({file, element.line}, "the file ends too early for " +
                                                       std::to_string(element.count) +
                                                       (i == 0 ? " vertices" : " faces"));
        }
        bytes -= element.count * least;
    }
}

}  // namespace

void read_ply(std::string content, const std::string& file, MeshImporter& importer) {
    blank_byte_order_mark(content);
    const bool has_cr_lines = content.find("\rformat ascii") < content.find('\n');
    if (has_cr_lines) plain_text(content);
    MeshLines lines(content, file);
    const PlyHeader header = take_ply_header(lines);
    check_header(header, file);
    if (header.format == "ascii") {
        plain_text(content);
        read_lists(lines,
                   {.vertices = header.elements[0].count,
                    .faces = header.elements[1].count,
                    .words_a_vertex = header.elements[0].properties.size(),
                    .columns = columns_of(header.elements[0])},
                   importer);
        return;
    }
    const std::size_t body = lines.position();
    check_size(header, content.size() - body, file);
    content.replace(0, body, plain_header(header));
    read_checked({.content = std::move(content), .reader = "ply", .is_binary = true}, file,
                 importer);
}

}  // namespace rt
