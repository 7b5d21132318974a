#include "scenes/meshes/polygons.hpp"

#include "common/geometry/mesh_normals.hpp"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include <cassert>

namespace rt {

namespace {

struct InDouble : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<InDouble>;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<InDouble>;

template <class OpenMeshMesh>
OpenMeshMesh to_open_mesh(const Polygons& polygons) {
    OpenMeshMesh mesh;
    for (const glm::dvec3& v : polygons.vertices) mesh.add_vertex({v.x, v.y, v.z});
    for (const std::vector<int>& face : polygons.faces) {
        std::vector<OpenMesh::VertexHandle> corners;
        for (const int corner : face) corners.emplace_back(corner);
        [[maybe_unused]] const auto added = mesh.add_face(corners);
        assert(added.is_valid());  // else it is not a manifold
    }
    return mesh;
}

template <class OpenMeshMesh>
Polygons from_open_mesh(const OpenMeshMesh& mesh) {
    Polygons polygons;
    for (const auto vertex : mesh.vertices()) {
        const auto point = mesh.point(vertex);
        polygons.vertices.emplace_back(point[0], point[1], point[2]);
    }
    for (const auto face : mesh.faces()) {
        std::vector<int> corners;
        for (const auto vertex : mesh.fv_range(face)) corners.push_back(vertex.idx());
        polygons.faces.push_back(corners);
    }
    return polygons;
}

template <template <class, class> class Rule, class OpenMeshMesh>
Polygons refined(const Polygons& polygons, int times) {
    auto mesh = to_open_mesh<OpenMeshMesh>(polygons);
    Rule<OpenMeshMesh, double> rule;
    rule.attach(mesh);
    rule(static_cast<std::size_t>(times));
    rule.detach();
    return from_open_mesh(mesh);
}

}  // namespace

Polygons catmull_clark(const Polygons& polygons, int times) {
    return refined<OpenMesh::Subdivider::Uniform::CatmullClarkT, PolyMesh>(polygons, times);
}

Polygons loop(const Polygons& polygons, int times) {
    return refined<OpenMesh::Subdivider::Uniform::LoopT, TriMesh>(polygons, times);
}

Polygons with_normals(Polygons polygons) {
    Mesh mesh;
    for (const glm::dvec3& v : polygons.vertices) mesh.vertices.emplace_back(v);
    for (const std::vector<int>& face : cut_up(polygons).faces) {
        mesh.triangles.push_back({static_cast<std::uint32_t>(face[0]),
                                  static_cast<std::uint32_t>(face[1]),
                                  static_cast<std::uint32_t>(face[2])});
    }
    add_smooth_normals(mesh);
    for (const Vec3& normal : mesh.normals) polygons.normals.emplace_back(normal);
    return polygons;
}

}  // namespace rt
