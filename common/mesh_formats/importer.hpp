// Takes what OpenMesh reads, as it reads it. Only mesh_file.cpp includes this: OpenMesh's headers
// and its half-edges stop here.
#pragma once

#include "common/mesh_file.hpp"

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

#include <array>
#include <cstdint>
#include <istream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rt {

/// What is wrong with a vertex or a face. Whoever knows where it stands adds that.
struct MeshRefusal {
    std::string message;
};

/// A receiver of vertices and faces that builds no half-edges: an edge of three faces, which they
/// cannot hold, is nothing special here. Throws MeshRefusal.
class MeshImporter final : public OpenMesh::IO::BaseImporter {
public:
    using Vertex = OpenMesh::VertexHandle;
    using Edge = OpenMesh::EdgeHandle;
    using Halfedge = OpenMesh::HalfedgeHandle;
    using Face = OpenMesh::FaceHandle;

    /// With `list`, each vertex and each face ends a line of that stream. If one does not, the
    /// stream fails: "1-2" is one word to us, but two numbers to OpenMesh, and then all that
    /// follows is off.
    /// `faces_without_area` have been left out before.
    explicit MeshImporter(std::istream* list = nullptr, std::size_t faces_without_area = 0)
        : list_(list), faces_without_area_(faces_without_area) {}

    /// The mesh, once all is read, with warnings of what was left out: without normals, unless each
    /// vertex of a triangle has one.
    [[nodiscard]] MeshFile take();

    Vertex add_vertex(const OpenMesh::Vec3f& point) override;
    Vertex add_vertex() override { return add_vertex(OpenMesh::Vec3f(0.0f)); }
    void set_point(Vertex vertex, const OpenMesh::Vec3f& point) override;
    /// For the vertex in the faces to come: a second normal of the same vertex splits it, as at the
    /// edges of a cube whose faces have a normal each.
    void set_normal(Vertex vertex, const OpenMesh::Vec3f& normal) override;
    void set_normal(Vertex vertex, const OpenMesh::Vec3d& normal) override {
        set_normal(vertex, OpenMesh::Vec3f(normal));
    }
    Face add_face(const VHandles& corners) override;

    /// The numbers have been checked: the file is large enough for them.
    void reserve(unsigned int vertices, unsigned int edges, unsigned int faces) override;

    [[nodiscard]] std::size_t n_vertices() const override { return mesh_.vertices.size(); }
    [[nodiscard]] std::size_t n_faces() const override { return faces_; }
    [[nodiscard]] std::size_t n_edges() const override { return 0; }

    // What a mesh of ours has not.
    Halfedge add_edge(Vertex, Vertex) override { return Halfedge(); }
    Face add_face(Halfedge) override { return Face(); }
    void add_face_texcoords(Face, Vertex, const std::vector<OpenMesh::Vec2f>&) override {}
    void add_face_texcoords(Face, Vertex, const std::vector<OpenMesh::Vec3f>&) override {}
    void set_face_texindex(Face, int) override {}
    void set_halfedge(Vertex, Halfedge) override {}
    void set_color(Vertex, const OpenMesh::Vec3uc&) override {}
    void set_color(Vertex, const OpenMesh::Vec4uc&) override {}
    void set_color(Vertex, const OpenMesh::Vec3f&) override {}
    void set_color(Vertex, const OpenMesh::Vec4f&) override {}
    void set_texcoord(Vertex, const OpenMesh::Vec2f&) override {}
    void set_status(Vertex, const OpenMesh::Attributes::StatusInfo&) override {}
    void set_next(Halfedge, Halfedge) override {}
    void set_face(Halfedge, Face) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(Halfedge, const OpenMesh::Vec2f&) override {}
    void set_texcoord(Vertex, const OpenMesh::Vec3f&) override {}
    void set_texcoord(Halfedge, const OpenMesh::Vec3f&) override {}
    void set_status(Halfedge, const OpenMesh::Attributes::StatusInfo&) override {}
    void set_color(Edge, const OpenMesh::Vec3uc&) override {}
    void set_color(Edge, const OpenMesh::Vec4uc&) override {}
    void set_color(Edge, const OpenMesh::Vec3f&) override {}
    void set_color(Edge, const OpenMesh::Vec4f&) override {}
    void set_status(Edge, const OpenMesh::Attributes::StatusInfo&) override {}
    void set_normal(Face, const OpenMesh::Vec3f&) override {}
    void set_normal(Face, const OpenMesh::Vec3d&) override {}
    void set_color(Face, const OpenMesh::Vec3uc&) override {}
    void set_color(Face, const OpenMesh::Vec4uc&) override {}
    void set_color(Face, const OpenMesh::Vec3f&) override {}
    void set_color(Face, const OpenMesh::Vec4f&) override {}
    void set_status(Face, const OpenMesh::Attributes::StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}

private:
    /// The place in mesh_ of the vertex, which must be there.
    [[nodiscard]] std::uint32_t checked(Vertex vertex) const;
    void require_end_of_line();
    [[nodiscard]] std::uint32_t copy_with(std::uint32_t vertex, glm::vec3 normal);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    std::istream* list_;
    MeshFile mesh_;
    std::vector<bool> has_normal_;
    std::size_t faces_ = 0;
    std::size_t faces_without_area_;      ///< of fewer than three vertices
    std::vector<std::uint32_t> corners_;  ///< of one face; kept for its memory

    /// A vertex with several normals: its copies, and which of them the next face uses.
    std::map<std::pair<std::uint32_t, std::array<float, 3>>, std::uint32_t> copies_;
    std::map<std::uint32_t, std::uint32_t> used_;
};

}  // namespace rt
