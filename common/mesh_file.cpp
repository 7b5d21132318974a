#include "common/mesh_file.hpp"

#include "common/input_error.hpp"
#include "common/input_file.hpp"
#include "common/mesh_formats/formats.hpp"
#include "common/mesh_formats/importer.hpp"
#include "common/mesh_formats/text.hpp"

#include <OpenMesh/Core/IO/MeshIO.hh>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace rt {

namespace {

using Check = CheckedMesh (*)(std::string content, const std::string& file);

/// The check for the format that the file name indicates.
Check check_for(const std::string& file) {
    std::string kind = std::filesystem::path(file).extension().string();
    for (char& c : kind) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    if (kind == ".off") return checked_off;
    if (kind == ".obj") return checked_obj;
    if (kind == ".ply") return checked_ply;
    if (kind == ".stl") return checked_stl;
    throw InputError({file},
                     "is not a mesh: expected a name that ends in .off, .obj, .ply or .stl");
}

void require_size(std::uintmax_t size, const std::string& file) {
    if (size <= largest_mesh_file) return;
    throw InputError({file}, "is larger than " + std::to_string(largest_mesh_file >> 20) +
                                 " MiB: expected a smaller mesh");
}

/// The position at which OpenMesh's stream stopped.
struct Stop {
    Place place;
    std::string word;  ///< word at or before the position
};

Stop stop_of(std::istringstream& stream, const CheckedMesh& mesh, const std::string& file) {
    if (mesh.is_binary) return {.place = {file}};
    stream.exceptions(std::ios::goodbit);
    stream.clear();
    const std::string text = stream.str();
    const auto told = static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0));
    // The offset of the last byte read: part of a number, or the end of a line.
    const std::size_t last = std::max(std::min(told, text.size()), mesh.body + 1) - 1;
    const auto lines = std::count(text.begin() + static_cast<std::ptrdiff_t>(mesh.body),
                                  text.begin() + static_cast<std::ptrdiff_t>(last), '\n');
    constexpr const char* blanks = " \t\r\n";
    const std::size_t begin = text.find_last_of(blanks, last) + 1;
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    return {.place = {file, mesh.body_line + static_cast<int>(lines)},
            .word = quoted_word(std::string_view(text).substr(begin, end - begin))};
}

/// Disables OpenMesh's messages on the terminal; the program reports a single error instead.
void silence_open_mesh() {
    omerr().disable();
    omlog().disable();
    omout().disable();
}

bool has_area(const MeshFile& mesh) {
    return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&mesh](const auto& corners) {
        const glm::dvec3 a = mesh.vertices[corners[0]];
        const glm::dvec3 b = mesh.vertices[corners[1]];
        const glm::dvec3 c = mesh.vertices[corners[2]];
        return glm::cross(b - a, c - a) != glm::dvec3(0);
    });
}

MeshFile read_checked(CheckedMesh mesh, const std::string& file) {
    silence_open_mesh();
    std::istringstream stream(std::move(mesh.content), std::ios::in | std::ios::binary);
    // The PLY reader does not check whether it has read a number. The others read line by line
    // until the end, and misread nothing after the checks.
    const bool is_ply = mesh.reader == std::string_view("ply");
    if (is_ply) stream.exceptions(std::ios::failbit | std::ios::badbit);
    MeshImporter importer(is_ply && !mesh.is_binary ? &stream : nullptr, mesh.faces_without_area);
    OpenMesh::IO::Options options = OpenMesh::IO::Options::VertexNormal;
    if (mesh.is_binary) options += OpenMesh::IO::Options::Binary;
    try {
        const bool is_read = OpenMesh::IO::IOManager().read(stream, mesh.reader, importer, options);
        if (!is_read) throw InputError({file}, "is not a mesh that OpenMesh can read");
    } catch (const MeshRefusal& refusal) {
        throw InputError(stop_of(stream, mesh, file).place, refusal.message);
    } catch (const std::ios_base::failure&) {
        const auto [place, word] = stop_of(stream, mesh, file);
        if (mesh.is_binary) throw InputError(place, "the file ends too early");
        throw InputError(
            place, "expected a number in the range of float, or an existing vertex, not " + word);
    }
    MeshFile result = importer.take();
    if (result.triangles.empty()) {
        throw InputError({file}, "has no triangles: expected at least one");
    }
    if (!has_area(result))
        result.warnings.emplace_back("no triangle has an area: no ray hits the mesh");
    return result;
}

}  // namespace

MeshFile parse_mesh_file(std::string content, const std::string& file) {
    const Check checked = check_for(file);
    if (content.empty()) throw InputError({file}, "is empty: expected a mesh");
    require_size(content.size(), file);
    return read_checked(checked(std::move(content), file), file);
}

MeshFile read_mesh_file(const std::string& file) {
    // Checks that need not read much. A device may be endless, and a pipe cannot be read twice.
    static_cast<void>(check_for(file));
    std::error_code has_none;
    const auto status = std::filesystem::status(file, has_none);
    if (std::filesystem::exists(status) && std::filesystem::is_other(status))
        throw InputError({file}, "is a device or a pipe: expected a file");
    const std::uintmax_t size = std::filesystem::file_size(file, has_none);
    if (!has_none) require_size(size, file);
    return parse_mesh_file(read_input_file(file, largest_mesh_file), file);
}

}  // namespace rt
