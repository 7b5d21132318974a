// Receives vertices and faces from OpenMesh's readers and from the project's. Only the formats and
// mesh_file.cpp include this file, so that OpenMesh's headers and half-edges are used nowhere else.
#pragma once

#include "common/mesh_file/mesh_file.hpp"

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rt {

/// An error in a vertex or a face. The catching function adds the location.
struct MeshRefusal {
    std::string message;
};

/// The message for the index of a vertex, from 0, in a file of this many.
[[nodiscard]] std::string no_such_vertex(std::int64_t index, std::uint64_t count);

/// A receiver of vertices and faces that builds no half-edges. An edge of three faces, which
/// half-edges cannot represent, is therefore accepted. Throws MeshRefusal.
class MeshImporter final : public OpenMesh::IO::BaseImporter {
public:
    using Vertex = OpenMesh::VertexHandle;
    using Edge = OpenMesh::EdgeHandle;
    using Halfedge = OpenMesh::HalfedgeHandle;
    using Face = OpenMesh::FaceHandle;

    /// Returns the mesh after all has been read, with warnings about omitted parts. It has normals
    /// only if each vertex of a triangle has one. Throws MeshRefusal if it has no triangle.
    [[nodiscard]] MeshFile take();

    Vertex add_vertex(const OpenMesh::Vec3f& point) override;
    Vertex add_vertex() override { return add_vertex(OpenMesh::Vec3f(0.0f)); }
    void set_point(Vertex vertex, const OpenMesh::Vec3f& point) override;
    /// Sets the normal of the vertex for the faces that follow. A second normal of the same vertex
    /// splits the vertex, as at the edges of a cube whose faces have a normal each.
    void set_normal(Vertex vertex, const OpenMesh::Vec3f& normal) override;
    void set_normal(Vertex vertex, const OpenMesh::Vec3d& normal) override {
        set_normal(vertex, OpenMesh::Vec3f(normal));
    }
    Face add_face(const VHandles& corners) override;
    /// Counts faces of fewer than three different vertices that are not added.
    void leave_out_faces(std::size_t count) { faces_without_area_ += count; }

    /// The counts have been checked: the file is large enough for them.
    void reserve(unsigned int vertices, unsigned int edges, unsigned int faces) override;

    [[nodiscard]] std::size_t n_vertices() const override { return mesh_.vertices.size(); }
    [[nodiscard]] std::size_t n_faces() const override { return faces_; }
    [[nodiscard]] std::size_t n_edges() const override { return 0; }

    // Properties that MeshFile does not have.
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
    /// The index in mesh_ of the vertex. Throws MeshRefusal if there is no such vertex.
    [[nodiscard]] std::uint32_t checked(Vertex vertex) const;
    [[nodiscard]] std::uint32_t copy_with(std::uint32_t vertex, glm::vec3 normal);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    MeshFile mesh_;
    std::vector<bool> has_normal_;
    std::size_t faces_ = 0;
    std::size_t faces_without_area_ = 0;  ///< faces of fewer than three different vertices
    std::vector<std::uint32_t>
        corners_;  ///< corners of one face; a member so that its memory is reused

    /// For a vertex with several normals: its copies, and the copy that the next face uses.
    std::map<std::pair<std::uint32_t, std::array<float, 3>>, std::uint32_t> copies_;
    std::map<std::uint32_t, std::uint32_t> used_;
};

}  // namespace rt
