// Shortcuts for reading a mesh in a test.
#pragma once

#include "common/geometry/mesh_normals.hpp"
#include "common/mesh_file/load_mesh.hpp"
#include "common/system/input_error.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

/// A folder that is removed after the test.
struct MeshFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() /
        (sizeof(Real) == 4 ? "raysteps_meshes_f32" : "raysteps_meshes_f64");
    MeshFolder() { std::filesystem::create_directories(path); }
    ~MeshFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;

    std::string write(const std::string& name, std::string_view content) const {
        std::ofstream(path / name, std::ios::binary) << content;
        return (path / name).string();
    }
};

/// The mesh that the content of a file of that name is.
inline Mesh mesh_of(const std::string& name, std::string_view content) {
    const MeshFolder folder;
    return load_mesh(folder.write(name, content));
}

/// The warnings about the file, without the folder.
inline std::vector<std::string> mesh_warnings(const std::string& name, std::string_view content) {
    const MeshFolder folder;
    std::vector<std::string> all;
    static_cast<void>(load_mesh(folder.write(name, content), [&](const std::string& warning) {
        all.push_back(warning.substr(folder.path.string().size() + 1));
    }));
    return all;
}

/// A triangle in STL.
inline const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\n";

/// The header of a text PLY.
inline std::string ply_header(int vertices, int faces) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// A text STL with blanks, capitals and ends of lines as some programs write them.
inline std::string as_stl(const Mesh& mesh) {
    std::string text = "solid outer space\n";
    for (const auto& t : mesh.triangles) {
        text += "facet normal 0 0 0\n  OUTER loop\r\n\n";
        for (const std::uint32_t corner : t) {
            const Vec3 v = mesh.vertices[corner];
            text += "  vertex " + std::to_string(v.x) + " " + std::to_string(v.y) + " " +
                    std::to_string(v.z) + "\n";
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid outer space\n";
}

/// The mesh with smooth normals.
inline Mesh smoothed(Mesh mesh) {
    add_smooth_normals(mesh);
    return mesh;
}

/// The error message for the file, without the folder; "accepted" if there is none.
inline std::string mesh_refusal(const std::string& name, std::string_view content) {
    const MeshFolder folder;
    try {
        static_cast<void>(load_mesh(folder.write(name, content)));
        return "accepted";
    } catch (const InputError& error) {
        return std::string(error.what()).substr(folder.path.string().size() + 1);
    }
}

/// The topology of a mesh.
struct Topology {
    int vertices = 0;  ///< used by a triangle
    int edges = 0;
    int triangles = 0;
    int open_edges = 0;    ///< of one triangle
    int shared_edges = 0;  ///< of more than two triangles, or of two with different orientations
    int parts = 0;
    [[nodiscard]] int euler() const { return vertices - edges + triangles; }
};

inline Topology topology(const Mesh& mesh) {
    // Each edge from its smaller to its larger vertex: the number of uses in each direction.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;
    std::map<std::uint32_t, std::uint32_t> part_of;
    const auto root = [&part_of](std::uint32_t v) {
        part_of.try_emplace(v, v);
        while (part_of[v] != v) v = part_of[v] = part_of[part_of[v]];
        return v;
    };
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangle[i];
            const std::uint32_t to = triangle[(i + 1) % 3];
            auto& [along, against] = edges[std::minmax(from, to)];
            ++(from < to ? along : against);
            part_of[root(from)] = root(to);
        }
    }
    Topology result = {.vertices = static_cast<int>(part_of.size()),
                       .edges = static_cast<int>(edges.size()),
                       .triangles = static_cast<int>(mesh.triangles.size())};
    for (const auto& [edge, ways] : edges) {
        const auto [along, against] = ways;
        result.open_edges += along + against == 1;
        result.shared_edges += along + against > 1 && (along != 1 || against != 1);
    }
    for (const auto& [vertex, part] : part_of) result.parts += vertex == part;
    return result;
}

}  // namespace RT_PRECISION
}  // namespace rt
