#include "common/mesh_file/half_edges.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace rt {

namespace {

using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<>;

/// The half-edges of triangles of which none is turned over; what has one side is cut open.
/// Half-edges need a vertex for each fan of triangles: where two fans touch in a vertex, and at
/// crowded edges, it is one for each.
HalfEdges half_edges(const Triangles& triangles, const std::vector<std::uint32_t>& others) {
    const auto groups = corner_groups(triangles, others, [](auto, auto) { return true; });
    std::vector<HalfEdges::VertexHandle> vertices(groups.size());
    HalfEdges mesh;
    mesh.reserve(groups.size() / 6, groups.size() / 2, triangles.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
        auto& vertex = vertices[groups[i]];
        if (!vertex.is_valid()) vertex = mesh.add_vertex({0, 0, 0});
    }
    for (std::size_t i = 0; i < groups.size(); i += 3) {
        mesh.add_face(vertices[groups[i]], vertices[groups[i + 1]], vertices[groups[i + 2]]);
    }
    return mesh;
}

/// Counts the closed ways along half-edges without a face.
void count_holes(const HalfEdges& mesh, MeshForm& form) {
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

std::size_t count_crowded(const Triangles& triangles, const std::vector<std::uint32_t>& others) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t side = 0; side < others.size(); ++side)
        if (others[side] == crowded)
            edges.insert(
                std::minmax(triangles[side / 3][side % 3], triangles[side / 3][end_of(side) % 3]));
    return edges.size();
}

std::size_t count_parts(const Triangles& triangles, std::size_t vertices) {
    std::vector<std::uint32_t> parents(vertices);
    for (std::uint32_t i = 0; i < vertices; ++i) parents[i] = i;
    std::size_t parts = 0;
    std::vector<bool> is_used(vertices);
    const auto root = [&parents](std::uint32_t i) {
        while (parents[i] != i) i = parents[i] = parents[parents[i]];
        return i;
    };
    for (const auto& corners : triangles) {
        for (const std::uint32_t corner : corners) {
            parts += !is_used[corner];
            is_used[corner] = true;
            const std::uint32_t a = root(corners[0]);
            const std::uint32_t b = root(corner);
            parts -= a != b;
            parents[std::max(a, b)] = std::min(a, b);
        }
    }
    return parts;
}

}  // namespace

MeshForm form_of(const Triangles& triangles, std::size_t vertices) {
    MeshForm form = {.parts = count_parts(triangles, vertices)};
    auto others = other_sides(triangles, vertices);
    form.crowded_edges = count_crowded(triangles, others);
    const Orientation orientation = orientation_of(triangles, others);
    const auto& is_turned = orientation.is_turned;
    form.turned = orientation.turned;
    form.one_sided = orientation.one_sided;
    Triangles consistent = triangles;
    for (std::size_t i = 0; i < is_turned.size(); ++i)
        if (is_turned[i]) std::swap(consistent[i][1], consistent[i][2]);
    if (!is_turned.empty()) others = other_sides(consistent, vertices);
    count_holes(half_edges(consistent, others), form);
    return form;
}

}  // namespace rt
