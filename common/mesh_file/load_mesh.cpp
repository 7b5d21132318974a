#include "common/mesh_file/load_mesh.hpp"

#include "common/geometry/mesh_edges.hpp"
#include "common/geometry/mesh_normals.hpp"
#include "common/mesh_file/mesh_file.hpp"
#include "common/system/huge_pages.hpp"
#include "common/system/text.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace rt {
inline namespace RT_PRECISION {

namespace {

/// The largest share of a triangle's size by which rounding to float may move its corners unseen.
constexpr double unseen_share = 1e-4;

glm::dvec3 as_float(glm::dvec3 point) {
    return glm::dvec3(glm::vec3(point));
}

double largest_of(glm::dvec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Returns whether the mesh looks the same with coordinates of float. (A triangle whose corners are
/// in one place is never seen.)
[[maybe_unused]] bool is_same_in_float(const MeshFile& content) {
    return std::ranges::all_of(content.triangles, [&](const auto& corners) {
        const glm::dvec3 a = content.vertices[corners[0]];
        const glm::dvec3 b = content.vertices[corners[1]];
        const glm::dvec3 c = content.vertices[corners[2]];
        const glm::dvec3 moved =
            glm::max(glm::abs(a - as_float(a)),
                     glm::max(glm::abs(b - as_float(b)), glm::abs(c - as_float(c))));
        const double size = std::max(largest_of(b - a), largest_of(c - a));
        return size == 0 || largest_of(moved) <= unseen_share * size;
    });
}

/// Double keeps the digits that float would lose in sight; other meshes are rounded, because
/// packets of floats are faster.
std::vector<Vec3> rounded_vertices(const MeshFile& content) {
    std::vector<Vec3> result;
    reserve_huge(result, content.vertices.size());
    const bool in_float = sizeof(Real) == sizeof(float) || is_same_in_float(content);
    for (const glm::dvec3& vertex : content.vertices)
        result.push_back(in_float ? Vec3(glm::vec3(vertex)) : Vec3(vertex));
    return result;
}

/// The smallest box around the triangles: its lowest and its highest corner.
std::pair<glm::dvec3, glm::dvec3> box_of(const MeshFile& content) {
    glm::dvec3 low(content.vertices[content.triangles[0][0]]);
    glm::dvec3 high = low;
    for (const auto& corners : content.triangles) {
        for (const std::uint32_t corner : corners) {
            low = glm::min(low, content.vertices[corner]);
            high = glm::max(high, content.vertices[corner]);
        }
    }
    return {low, high};
}

/// The file's normals, of unit length; where one has no direction, the smooth normal.
void set_normals(Mesh& mesh, const MeshFile& content) {
    Mesh smooth;
    reserve_huge(mesh.normals, content.normals.size());
    for (std::size_t i = 0; i < content.normals.size(); ++i) {
        const double length = glm::length(content.normals[i]);
        if (length > 0) {
            mesh.normals.emplace_back(content.normals[i] / length);
            continue;
        }
        if (smooth.normals.empty()) {
            smooth = {.vertices = mesh.vertices, .triangles = mesh.triangles};
            add_smooth_normals(smooth);
        }
        mesh.normals.push_back(smooth.normals[i]);
    }
}

/// Leaves out the facets with the corners of another one, either way around. So some programs write
/// a surface that is seen from both sides; shading turns every normal to the eye.
void leave_out_doubled(Triangles& triangles, const Warn& warn) {
    Triangles sorted = triangles;
    for (auto& corners : sorted) std::ranges::sort(corners);
    std::vector<std::uint32_t> order(sorted.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return sorted[i]; });
    std::vector<bool> is_double(sorted.size());
    for (std::size_t i = 1; i < order.size(); ++i)
        is_double[order[i]] = sorted[order[i]] == sorted[order[i - 1]];
    std::size_t index = 0;
    const auto doubled = std::erase_if(triangles, [&](const auto&) { return is_double[index++]; });
    if (doubled > 0)
        warn(std::to_string(doubled) + (doubled == 1 ? " facet has" : " facets have") +
             " the corners of another one: left out");
}

/// A sentence about coordinates that are all floats, and too coarse there: the file has no digits
/// that double could keep. Empty if there is no such loss, or no last digit of a float in use.
std::string loss_in_file(const MeshFile& content, glm::dvec3 low, glm::dvec3 high) {
    const double size = largest_of(high - low);
    double step = 0;
    for (const glm::dvec3& vertex : content.vertices) {
        if (vertex != as_float(vertex)) return "";
        for (int i = 0; i < 3; ++i) {
            const float value = std::abs(float(vertex[i]));
            const bool has_last_digit = (std::bit_cast<std::uint32_t>(value) & 1) != 0;
            if (has_last_digit) step = std::max(step, double(value - std::nextafter(value, 0.F)));
        }
    }
    if (!(step / 2 > unseen_share * size)) return "";
    return formatted(
        "all coordinates are floats, which have steps of %.2g here, and the mesh is %.2g large: it "
        "may have lost its shape before it was written",
        step, size);
}

void warn_of_loss(const MeshFile& content, const Warn& warn_of) {
    const auto [low, high] = box_of(content);
    const std::string in_file = loss_in_file(content, low, high);
    if (!in_file.empty()) warn_of(in_file);
#ifdef RT_FLOAT
    const std::string in_float = loss_in_float(low, high);
    if (in_file.empty() && !in_float.empty()) warn_of(in_float + "; try --precision double");
#endif
}

void warn_of_sides(const Orientation& orientation, std::size_t triangles, const std::string& file,
                   const Warn& warn) {
    const auto warn_of = [&](std::size_t count, const char* one, const char* many,
                             const std::string& then) {
        if (count == 0) return;
        warn(to_string(FileLocation{file}) + "warning: " + std::to_string(count) + " of " +
             std::to_string(triangles) + " triangles " + (count == 1 ? one : many) + then +
             "try normals:flat");
    };
    warn_of(orientation.turned, "is", "are",
            " turned over, compared to their neighbors, and shading around them is wrong: "
            "mend the file, or ");
    warn_of(orientation.one_sided, "belongs", "belong",
            " to a surface with only one side, as a Möbius band has, and shading has an edge where "
            "neighbors turn the other way: ");
}

/// Turns facets over that are turned, compared to their neighbors: shading sees both sides of a
/// facet, but smooth normals need them alike. Warns of surfaces with only one side.
void turn_over(Mesh& mesh, const std::string& file, const Warn& warn) {
    Orientation orientation =
        orientation_of(mesh.triangles, other_sides(mesh.triangles, mesh.vertices.size()));
    for (std::size_t i = 0; i < orientation.is_turned.size(); ++i)
        if (orientation.is_turned[i]) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
    orientation.turned = 0;
    if (warn) warn_of_sides(orientation, mesh.triangles.size(), file, warn);
}

}  // namespace

std::string loss_in_float(glm::dvec3 low, glm::dvec3 high) {
    const double largest = std::max(largest_of(low), largest_of(high));
    const double shift = double(std::numeric_limits<float>::epsilon()) / 2 * largest;
    const double size = largest_of(high - low);
    if (!(shift > unseen_share * size)) return "";
    return formatted(
        "coordinates reach %.3g, where float moves points by up to %.2g, and the mesh is %.2g "
        "large",
        largest, shift, size);
}

void warn_of_turned_triangles(const Mesh& mesh, const std::string& file, const Warn& warn) {
    const auto others = other_sides(mesh.triangles, mesh.vertices.size());
    warn_of_sides(orientation_of(mesh.triangles, others), mesh.triangles.size(), file, warn);
}

Mesh load_mesh(const std::string& file, const Warn& warn, bool smooth) {
    MeshFile content = read_mesh_file(file);
    const auto warn_of = [&](const std::string& warning, int line = 0) {
        if (warn) warn(to_string(FileLocation{file, line}) + "warning: " + warning);
    };
    for (const auto& [text, line, of_normals] : content.warnings)
        if (smooth || !of_normals) warn_of(text, line);
    warn_of_loss(content, warn_of);
    std::vector<Vec3> vertices = rounded_vertices(content);  // which looks at the triangles
    Mesh mesh = {.vertices = std::move(vertices), .triangles = std::move(content.triangles)};
    if (content.facets) leave_out_doubled(mesh.triangles, warn_of);
    if (!smooth) return mesh;
    set_normals(mesh, content);
    if (!mesh.normals.empty()) {
        turn_to_normals(mesh);
    } else if (content.crease) {
        if (content.facets) turn_over(mesh, file, warn);
        add_creased_normals(mesh, *content.crease);
    }
    return mesh;
}

}  // namespace RT_PRECISION
}  // namespace rt
