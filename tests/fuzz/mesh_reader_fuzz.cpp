// libFuzzer's entry into the mesh reader, for each of the four formats. docs/reference/meshes.md
// explains how to run it.

#include "common/mesh_file/half_edges.hpp"
#include "common/mesh_file/mesh_file.hpp"
#include "common/system/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken invariant: %s\n", what);
    std::abort();
}

void check_mesh(const rt::MeshFile& mesh, std::size_t size) {
    require(!mesh.triangles.empty(), "there is a triangle");
    require(mesh.triangles.size() <= size && mesh.vertices.size() <= size,
            "each vertex and each triangle takes a byte of the file");
    require(mesh.normals.empty() || mesh.normals.size() == mesh.vertices.size(),
            "all vertices have a normal, or none has");
    for (const glm::dvec3& v : mesh.vertices) {
        require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z),
                "vertices are finite");
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        require(std::max({a, b, c}) < mesh.vertices.size(), "corners are vertices");
        require(a != b && b != c && c != a, "a triangle has three corners");
    }
    const rt::MeshForm form = rt::form_of(mesh.triangles, mesh.vertices.size());
    require(form.parts >= 1 && form.parts <= mesh.triangles.size(), "a part has a triangle");
    require(2 * form.turned <= mesh.triangles.size(), "most triangles are not turned over");
    require((form.holes == 0) == (form.longest_hole == 0), "a hole has edges");
}

void check_message(const std::string& message) {
    const auto printable = [](char c) { return ' ' <= c && c <= '~'; };
    require(message.starts_with("fuzz."), "a message begins with the file");
    require(message.find("error: ") != std::string::npos, "a message says what it is");
    require(std::all_of(message.begin(), message.end(), printable), "a message is printable");
    require(message.size() < 400, "a message is short");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // char may alias any object's bytes.
    const std::string content(reinterpret_cast<const char*>(data), size);
    for (const char* file : {"fuzz.off", "fuzz.obj", "fuzz.ply", "fuzz.stl"}) {
        try {
            check_mesh(rt::parse_mesh_file(content, file), size);
        } catch (const rt::InputError& error) {
            check_message(error.what());
        }
    }
    return 0;
}
