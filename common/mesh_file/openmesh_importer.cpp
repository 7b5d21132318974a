#include "common/mesh_file/openmesh_importer.hpp"

#include "common/mesh_file/triangulate.hpp"
#include "common/system/huge_pages.hpp"

#include <cmath>
#include <utility>

namespace rt {

std::string no_such_vertex(std::int64_t index, std::uint64_t count) {
    const std::string start = "vertex " + std::to_string(index) + " is not there: ";
    if (count == 0) return start + "the file has none";
    return start + "expected 0 to " + std::to_string(count - 1);
}

namespace {

glm::vec3 as_glm(const OpenMesh::Vec3f& v) {
    return {v[0], v[1], v[2]};
}

void require_finite(const OpenMesh::Vec3f& point, std::size_t vertex) {
    if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])) return;
    throw MeshRefusal{"vertex " + std::to_string(vertex) +
                      " is not a place: expected three numbers up to 3.4e38"};
}

}  // namespace

OpenMesh::VertexHandle MeshImporter::add_vertex(const OpenMesh::Vec3f& point) {
    require_finite(point, mesh_.vertices.size());
    mesh_.vertices.push_back(as_glm(point));
    return Vertex(static_cast<int>(mesh_.vertices.size() - 1));
}

void MeshImporter::reserve(unsigned int vertices, unsigned int /*edges*/, unsigned int faces) {
    reserve_huge(mesh_.vertices, vertices);
    reserve_huge(mesh_.triangles, faces);
}

void MeshImporter::set_point(Vertex vertex, const OpenMesh::Vec3f& point) {
    const std::uint32_t place = checked(vertex);
    require_finite(point, place);
    mesh_.vertices[place] = as_glm(point);
}

std::uint32_t MeshImporter::checked(Vertex vertex) const {
    // As an unsigned number, the invalid index −1 is too large as well.
    const auto place = static_cast<std::uint32_t>(vertex.idx());
    if (place < mesh_.vertices.size()) return place;
    throw MeshRefusal{no_such_vertex(vertex.idx(), mesh_.vertices.size())};
}

void MeshImporter::set_normal(Vertex vertex, const OpenMesh::Vec3f& normal) {
    const std::uint32_t place = checked(vertex);
    mesh_.normals.resize(mesh_.vertices.size(), glm::vec3(0));
    has_normal_.resize(mesh_.vertices.size());
    if (!has_normal_[place]) {
        has_normal_[place] = true;
        mesh_.normals[place] = as_glm(normal);
    } else if (mesh_.normals[place] == as_glm(normal)) {
        used_.erase(place);
    } else {
        used_[place] = copy_with(place, as_glm(normal));
    }
}

std::uint32_t MeshImporter::copy_with(std::uint32_t vertex, glm::vec3 normal) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const std::array<float, 3> key = {normal.x, normal.y, normal.z};
    const auto [copy, is_new] = copies_.try_emplace({vertex, key}, next);
    if (is_new) {
        mesh_.vertices.push_back(mesh_.vertices[vertex]);
        mesh_.normals.push_back(normal);
        has_normal_.push_back(true);
    }
    return copy->second;
}

void MeshImporter::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    mesh_.triangles.push_back({a, b, c});
}

OpenMesh::FaceHandle MeshImporter::add_face(const VHandles& corners) {
    if (corners.size() > std::size_t(most_corners)) {
        throw MeshRefusal{"a face of " + std::to_string(corners.size()) +
                          " corners: expected at most " + std::to_string(most_corners)};
    }
    corners_.clear();
    for (const Vertex corner : corners) {
        std::uint32_t place = checked(corner);
        if (!used_.empty()) {
            const auto copy = used_.find(place);
            if (copy != used_.end()) place = copy->second;
        }
        // Successive equal vertices are one corner.
        if (corners_.empty() || corners_.back() != place) corners_.push_back(place);
    }
    while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
    const std::size_t before = mesh_.triangles.size();
    if (corners_.size() == 3) {
        add_triangle(corners_[0], corners_[1], corners_[2]);
    } else if (corners_.size() > 3) {
        std::vector<glm::dvec3> points;
        for (const std::uint32_t corner : corners_) points.emplace_back(mesh_.vertices[corner]);
        for (const auto& [a, b, c] : triangulate(points)) {
            add_triangle(corners_[a], corners_[b], corners_[c]);
        }
    }
    if (mesh_.triangles.size() == before) leave_out_faces(1);
    return Face(static_cast<int>(faces_++));
}

MeshFile MeshImporter::take() {
    const std::string few = std::to_string(faces_without_area_) +
                            (faces_without_area_ == 1 ? " face has" : " faces have") +
                            " fewer than three different corners";
    const bool has_few = faces_without_area_ > 0;
    if (mesh_.triangles.empty())
        throw MeshRefusal{"has no triangles: " + (has_few ? few : "expected at least one")};
    if (has_few) mesh_.warnings.push_back(few + ", and no area: left out");
    if (mesh_.normals.empty()) return std::move(mesh_);
    has_normal_.resize(mesh_.vertices.size());
    mesh_.normals.resize(mesh_.vertices.size(), glm::vec3(0));
    for (const auto& triangle : mesh_.triangles) {
        for (const std::uint32_t corner : triangle) {
            if (has_normal_[corner]) continue;
            mesh_.normals.clear();
            return std::move(mesh_);
        }
    }
    return std::move(mesh_);
}

}  // namespace rt
