#include "common/geometry/bounding_box.hpp"
#include "common/mesh_file/half_edges.hpp"
#include "common/mesh_file/load_mesh.hpp"
#include "common/mesh_file/welder.hpp"
#include "common/program/load_meshes.hpp"
#include "common/system/readable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

namespace rt {

namespace {

std::string counted(std::size_t count, const std::string& one) {
    return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

/// The triangles with one vertex for each place: a mesh has several where its normals differ.
std::pair<Triangles, std::size_t> welded(const Mesh& mesh) {
    Welder places;
    std::vector<std::uint32_t> place_of;
    std::size_t count = 0;
    for (const Vec3& vertex : mesh.vertices) {
        place_of.push_back(places.place(vertex));
        count = std::max(count, place_of.back() + std::size_t(1));
    }
    Triangles triangles;
    for (const auto& [i, j, k] : mesh.triangles) {
        const std::uint32_t a = place_of[i];
        const std::uint32_t b = place_of[j];
        const std::uint32_t c = place_of[k];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return {std::move(triangles), count};
}

std::string form_line(const MeshForm& form) {
    if (form.parts == 0) return "no part: none has an area";
    std::string text = counted(form.parts, "part");
    if (form.holes == 0) text += form.crowded_edges == 0 ? ", closed" : ", no hole";
    if (form.holes > 0) {
        text += ", " + counted(form.holes, "hole") +
                (form.holes == 1 ? " of " : ", the longest of ") +
                counted(form.longest_hole, "edge");
    }
    if (form.crowded_edges > 0)
        text += ", " + counted(form.crowded_edges, "edge") + " of three triangles or more";
    if (form.turned > 0) text += ", " + counted(form.turned, "triangle") + " turned over";
    if (form.one_sided > 0)
        text += ", " + counted(form.one_sided, "triangle") + " of a surface with only one side";
    return text;
}

std::string box_line(const Mesh& mesh) {
    BoundingBox box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) box = merged(box, mesh.vertices[corner]);
    const glm::dvec3 low = box.min;
    const glm::dvec3 high = box.max;
    const glm::dvec3 size = high - low;
    const double longest = std::max({size.x, size.y, size.z});
    // To a millionth of the size: the digits that matter to place the mesh.
    const double step = longest > 0 ? std::pow(10, std::floor(std::log10(longest)) - 6) : 0;
    const glm::dvec3 middle = step > 0 ? glm::round((low + high) / 2.0 / step) * step : low;
    std::array<char, 160> text;
    std::snprintf(text.data(), text.size(), "middle m %.12g,%.12g,%.12g, longest side e %.6g",
                  middle.x + 0.0, middle.y + 0.0, middle.z + 0.0, longest);
    const std::string loss = loss_in_float(low, high);
    return text.data() + (loss.empty() ? "" : "\n    at risk with --precision float: " + loss);
}

Mesh loaded(const MeshRequest& named) {
    try {
        return load_mesh(path_of(named));
    } catch (const InputError& error) {
        throw error.with(named_by(named.place));
    }
}

}  // namespace

std::string mesh_forms(const Scene& scene) {
    std::string lines;
    std::set<std::string> seen;
    for (const MeshRequest& named : scene.mesh_requests) {
        if (!seen.insert(named.file).second) continue;
        const Mesh mesh = loaded(named);
        const auto [triangles, vertices] = welded(mesh);
        lines += (seen.size() == 1 ? "with the meshes\n  " : "  ") + one_line(named.file) + ": " +
                 counted(mesh.triangles.size(), "triangle") + " in " +
                 form_line(form_of(triangles, vertices)) + "; " + box_line(mesh) + "\n";
    }
    return lines;
}

}  // namespace rt
