// Receives the vertices and faces of a file from the reader of its format.
#pragma once

#include "common/mesh_file/mesh_file.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
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

/// Collects a mesh, and cuts its faces into triangles.
class MeshBuilder {
public:
    /// Reserves memory; the file is large enough for these counts.
    void reserve(std::size_t vertices, std::size_t faces);

    /// Throws MeshRefusal unless float can represent the point.
    void add_vertex(glm::dvec3 point);
    /// Returns the vertex to use in a face whose corner at `vertex` has this normal: a copy if
    /// another face gave it another one, as at the edges of a cube whose faces have a normal each.
    /// A normal that is 0 or not a number has no direction, and is computed later.
    std::uint32_t with_normal(std::uint32_t vertex, glm::dvec3 normal);
    /// Adds the triangles of a face; its corners are indices of vertices. Leaves out a face without
    /// three different corners. Throws MeshRefusal for more than most_corners.
    void add_face(std::span<const std::uint32_t> corners);

    void warn(const std::string& warning, int line = 0) {
        mesh_.warnings.push_back({.text = warning, .line = line});
    }
    /// Warns of normals, which flat shading does not use.
    void warn_of_normals(const std::string& warning) {
        mesh_.warnings.push_back({.text = warning, .of_normals = true});
    }
    /// Edges whose faces meet at a larger angle stay sharp where normals are computed; in radians.
    void set_crease(double angle) { mesh_.crease = angle; }
    /// For a format whose vertices are shared only because they are in the same place.
    void set_facets(double crease) {
        mesh_.facets = true;
        mesh_.crease = crease;
    }

    [[nodiscard]] std::size_t vertex_count() const { return mesh_.vertices.size(); }

    /// Returns the mesh after all has been read, with warnings about omitted parts. It has normals
    /// only if each vertex of a triangle has one. Throws MeshRefusal if it has no triangle.
    [[nodiscard]] MeshFile take();

private:
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    [[nodiscard]] bool has_all_normals() const;

    MeshFile mesh_;
    std::vector<bool> has_normal_;
    std::size_t without_direction_ = 0;   ///< normals
    std::size_t faces_without_area_ = 0;  ///< faces of fewer than three different vertices
    std::vector<std::uint32_t> corners_;  ///< of one face; a member so that its memory is reused
    /// The copies of vertices with several normals.
    std::map<std::pair<std::uint32_t, std::array<double, 3>>, std::uint32_t> copies_;
};

// Numbers for places, the same for the same place.

/// Numbers places from 0, in the order in which they come: a hash table of open addresses.
class Welder {
public:
    /// Returns the number of a place that came before, else the next number. Coordinates are equal
    /// only if all of their digits are.
    std::uint32_t place(glm::dvec3 point);

private:
    [[nodiscard]] std::uint32_t& slot_of(glm::dvec3 point);
    void grow();

    std::vector<glm::dvec3> places_;
    std::vector<std::uint32_t> slots_;  ///< numbers from 1; 0 is free. A power of two of them
};

}  // namespace rt
