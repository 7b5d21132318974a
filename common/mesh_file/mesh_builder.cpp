#include "common/mesh_file/mesh_builder.hpp"

#include "common/mesh_file/triangulate.hpp"
#include "common/system/huge_pages.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rt {

namespace {

bool is_float(double value) {
    return std::abs(value) <= double(std::numeric_limits<float>::max());  // false for NaN
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::size_t hash(glm::dvec3 point) {
    std::uint64_t hash = 0;
    for (const double coordinate : {point.x, point.y, point.z}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 29U;
    }
    return std::size_t(hash ^ (hash >> 32U));
}

}  // namespace

std::string no_such_vertex(std::int64_t index, std::uint64_t count) {
    const std::string start = "vertex " + std::to_string(index) + " is not there: ";
    if (count == 0) return start + "the file has none";
    return start + "expected 0 to " + std::to_string(count - 1);
}

void MeshBuilder::reserve(std::size_t vertices, std::size_t faces) {
    reserve_huge(mesh_.vertices, vertices);
    reserve_huge(mesh_.triangles, faces);
}

void MeshBuilder::add_vertex(glm::dvec3 point) {
    if (!is_float(point.x) || !is_float(point.y) || !is_float(point.z))
        throw MeshRefusal{"vertex " + std::to_string(mesh_.vertices.size()) +
                          " is not a place: expected three numbers up to 3.4e38"};
    mesh_.vertices.push_back(point);
}

std::uint32_t MeshBuilder::with_normal(std::uint32_t vertex, glm::dvec3 normal) {
    const double length = glm::length(normal);
    const bool has_direction = length > 0 && std::isfinite(length);
    if (!has_direction) normal = glm::dvec3(0);  // NaN has no order in a map
    if (mesh_.normals.size() < mesh_.vertices.size()) {
        reserve_huge(mesh_.normals, mesh_.vertices.capacity());
        mesh_.normals.resize(mesh_.vertices.size(), glm::dvec3(0));
        has_normal_.resize(mesh_.vertices.size());
    }
    if (!has_normal_[vertex]) {
        has_normal_[vertex] = true;
        mesh_.normals[vertex] = normal;
        without_direction_ += !has_direction;
    }
    if (mesh_.normals[vertex] == normal) return vertex;
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const std::array<double, 3> key = {normal.x, normal.y, normal.z};
    const auto [copy, is_new] = copies_.try_emplace({vertex, key}, next);
    if (is_new) {
        mesh_.vertices.push_back(mesh_.vertices[vertex]);
        mesh_.normals.push_back(normal);
        has_normal_.push_back(true);
        without_direction_ += !has_direction;
    }
    return copy->second;
}

void MeshBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    mesh_.triangles.push_back({a, b, c});
}

void MeshBuilder::add_face(std::span<const std::uint32_t> corners) {
    if (corners.size() > std::size_t(most_corners)) {
        throw MeshRefusal{"a face of " + std::to_string(corners.size()) +
                          " corners: expected at most " + std::to_string(most_corners)};
    }
    const std::size_t before = mesh_.triangles.size();
    if (corners.size() == 3) {
        add_triangle(corners[0], corners[1], corners[2]);
    } else {
        corners_.clear();  // successive equal vertices are one corner
        std::unique_copy(corners.begin(), corners.end(), std::back_inserter(corners_));
        while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
        std::vector<glm::dvec3> points;
        for (const std::uint32_t corner : corners_) points.push_back(mesh_.vertices[corner]);
        for (const auto& [a, b, c] : triangulate(points))
            add_triangle(corners_[a], corners_[b], corners_[c]);
    }
    if (mesh_.triangles.size() == before) ++faces_without_area_;
}

bool MeshBuilder::has_all_normals() const {
    return std::ranges::all_of(mesh_.triangles, [this](const auto& corners) {
        return std::ranges::all_of(corners, [this](std::uint32_t corner) {
            return corner < has_normal_.size() && has_normal_[corner];
        });
    });
}

MeshFile MeshBuilder::take() {
    const std::string few = counted(faces_without_area_, "face has", "faces have") +
                            " fewer than three different corners";
    if (mesh_.triangles.empty())
        throw MeshRefusal{"has no triangles: " +
                          (faces_without_area_ > 0 ? few : "expected at least one")};
    if (faces_without_area_ > 0) warn(few + ", and no area: left out");
    if (!has_all_normals()) {
        mesh_.normals.clear();
    } else if (without_direction_ > 0) {
        warn_of_normals(counted(without_direction_, "normal is", "normals are") +
                        " zero or not a number: computed from the faces");
    }
    mesh_.normals.resize(mesh_.normals.empty() ? 0 : mesh_.vertices.size(), glm::dvec3(0));
    return std::move(mesh_);
}

std::uint32_t& Welder::slot_of(glm::dvec3 point) {
    std::size_t at = hash(point) & (slots_.size() - 1);
    while (slots_[at] != 0 && places_[slots_[at] - 1] != point) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
}

void Welder::grow() {
    slots_.assign(std::max<std::size_t>(2 * slots_.size(), 64), 0);
    for (std::uint32_t i = 0; i < places_.size(); ++i) slot_of(places_[i]) = i + 1;
}

std::uint32_t Welder::place(glm::dvec3 point) {
    point += 0.0;  // −0 becomes 0
    if (2 * places_.size() >= slots_.size()) grow();
    std::uint32_t& slot = slot_of(point);
    if (slot == 0) {
        places_.push_back(point);
        slot = std::uint32_t(places_.size());
    }
    return slot - 1;
}

}  // namespace rt
