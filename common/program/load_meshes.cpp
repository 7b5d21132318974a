#include "common/program/load_meshes.hpp"

#include "common/geometry/mesh_normals.hpp"
#include "common/mesh_file/load_mesh.hpp"
#include "common/scene/copies.hpp"

#include <array>
#include <map>
#include <utility>

namespace rt {

namespace {

/// Removes duplicate triangles. Call it after the normals are computed, in which each copy counts.
void leave_out_copied_triangles(Mesh& mesh) {
    using Corners = std::array<std::uint32_t, 3>;
    const auto& points = mesh.vertices;
    leave_out_copies(
        mesh.triangles,
        [&](const Corners& t) {
            return hash({points[t[0]], points[t[1]], points[t[2]]});
        },
        [&](const Corners& t, const Corners& u) {
            return points[t[0]] == points[u[0]] && points[t[1]] == points[u[1]] &&
                   points[t[2]] == points[u[2]];
        });
}

std::shared_ptr<const MeshGeometry> load_model(const std::string& file, bool smooth,
                                               const Warn& warn) {
    Mesh mesh = load_mesh(file, warn, smooth);
    if (smooth && mesh.normals.empty()) {
        warn_of_turned_triangles(mesh, file, warn);
        add_smooth_normals(mesh);
        turn_to_normals(mesh);
    }
    leave_out_copied_triangles(mesh);
    return mesh_geometry(std::move(mesh));
}

/// Throws InputError if a corner of the mesh in the scene is out of the range of Real.
void require_finite(const MeshInstance& mesh, const FileLocation& place) {
    const BoundingBox box = bounds(mesh);
    if (largest_component(glm::max(abs(box.min), abs(box.max))) < infinity) return;
    throw InputError(place, std::string("the mesh reaches out of the range of ") +
                                (sizeof(Real) == sizeof(float) ? "float" : "double") +
                                ": expected a smaller scale or position");
}

}  // namespace

void load_meshes(Scene& scene, const Warn& warn) {
    std::map<std::pair<std::string, bool>, std::shared_ptr<const MeshGeometry>> models;
    for (const MeshRequest& named : scene.mesh_requests) {
        auto& model = models[{path_of(named), named.smooth}];
        if (!model)
            model = read_named(named, warn, [&](const Warn& warn_of_line) {
                return load_model(path_of(named), named.smooth, warn_of_line);
            });
        const MeshInstance shape = {.model = model, .placement = named.placement};
        require_finite(shape, named.place);
        scene.meshes.push_back({.shape = shape, .material = named.material});
    }
}

}  // namespace rt
