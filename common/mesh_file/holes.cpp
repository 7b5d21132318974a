// The only file that includes OpenMesh. Where that is a shared library, this is one too: a program
// loads both with the first mesh whose holes are counted.
#include "common/mesh_file/half_edges.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <vector>

namespace rt {

namespace {

using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<>;

/// Half-edges need a vertex for each fan of triangles: where two fans touch in a vertex, and at
/// crowded edges, it is one for each.
HalfEdges half_edges(const std::vector<std::uint32_t>& groups) {
    std::vector<HalfEdges::VertexHandle> vertices(groups.size());
    HalfEdges mesh;
    mesh.reserve(groups.size() / 6, groups.size() / 2, groups.size() / 3);
    for (const std::uint32_t group : groups) {
        auto& vertex = vertices[group];
        if (!vertex.is_valid()) vertex = mesh.add_vertex({0, 0, 0});
    }
    for (std::size_t i = 0; i < groups.size(); i += 3)
        mesh.add_face(vertices[groups[i]], vertices[groups[i + 1]], vertices[groups[i + 2]]);
    return mesh;
}

}  // namespace

void raysteps_count_holes(const std::vector<std::uint32_t>& groups, MeshForm& form) {
    const HalfEdges mesh = half_edges(groups);
    std::vector<bool> is_seen(mesh.n_halfedges());
    for (const auto start : mesh.halfedges()) {
        if (!mesh.is_boundary(start) || is_seen[std::size_t(start.idx())]) continue;
        std::size_t length = 0;
        for (HalfEdges::HalfedgeHandle at = start; !is_seen[std::size_t(at.idx())];
             at = mesh.next_halfedge_handle(at), ++length)
            is_seen[std::size_t(at.idx())] = true;
        ++form.holes;
        form.longest_hole = std::max(form.longest_hole, length);
    }
}

}  // namespace rt
