#include "common/mesh_file/mesh_file.hpp"

#include "common/mesh_file/mesh_builder.hpp"
#include "common/mesh_file/mesh_formats.hpp"
#include "common/system/input_error.hpp"
#include "common/system/input_file.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>

namespace rt {

namespace {

using Read = void (*)(std::string& content, const std::string& file, MeshBuilder& builder);

/// The reader of the format that the file name indicates.
Read reader_for(const std::string& file) {
    std::string kind = std::filesystem::path(file).extension().string();
    for (char& c : kind) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
    if (kind == ".off") return read_off;
    if (kind == ".obj") return read_obj;
    if (kind == ".ply") return read_ply;
    if (kind == ".stl") return read_stl;
    throw InputError({file},
                     "is not a mesh: expected a name that ends in .off, .obj, .ply or .stl");
}

void require_size(std::uintmax_t size, const std::string& file) {
    if (size <= largest_mesh_file) return;
    throw InputError({file}, "is larger than " + std::to_string(largest_mesh_file >> 20) +
                                 " MiB: expected a smaller mesh");
}

bool has_area(const MeshFile& mesh) {
    return std::ranges::any_of(mesh.triangles, [&mesh](const auto& corners) {
        const glm::dvec3 a = mesh.vertices[corners[0]];
        const glm::dvec3 b = mesh.vertices[corners[1]];
        const glm::dvec3 c = mesh.vertices[corners[2]];
        return glm::cross(b - a, c - a) != glm::dvec3(0);
    });
}

}  // namespace

MeshFile parse_mesh_file(std::string content, const std::string& file) {
    const Read read = reader_for(file);
    if (content.empty()) throw InputError({file}, "is empty: expected a mesh");
    require_size(content.size(), file);
    // The 80 arbitrary bytes of a binary STL may begin so too.
    if (read != read_stl && is_utf16(content)) throw InputError({file}, text_in_utf16);
    if (content.starts_with("version https://git-lfs"))
        throw InputError({file}, "is a pointer of Git LFS, not the mesh: run git lfs pull");
    MeshBuilder builder;
    try {
        read(content, file, builder);
        MeshFile result = builder.take();
        if (!has_area(result))
            result.warnings.push_back({"no triangle has an area: no ray hits the mesh"});
        return result;
    } catch (const MeshRefusal& refusal) {
        throw InputError({file}, refusal.message);
    }
}

MeshFile read_mesh_file(const std::string& file) {
    static_cast<void>(reader_for(file));  // before a large file is read
    std::error_code has_none;
    const std::uintmax_t size = std::filesystem::file_size(file, has_none);
    if (!has_none) require_size(size, file);
    return parse_mesh_file(read_input_file(file, largest_mesh_file), file);
}

}  // namespace rt
