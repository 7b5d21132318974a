#include "common/geometry/bounding_box.hpp"
#include "common/mesh_file/half_edges.hpp"
#include "common/mesh_file/load_mesh.hpp"
#include "common/mesh_file/mesh_builder.hpp"
#include "common/program/load_meshes.hpp"
#include "common/system/escaping.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace rt {

namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
    return count == 1 ? tr(one) : tr(many, {{"number", count}});
}

std::string edges_of(std::size_t count) {
    return counted(count, to_translate("1 edge"), to_translate("{number} edges"));
}

std::string triangles_of(std::size_t count) {
    return counted(count, to_translate("1 triangle"), to_translate("{number} triangles"));
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
    if (form.parts == 0) return tr("no part: none has an area");
    std::string text = counted(form.parts, to_translate("1 part"), to_translate("{number} parts"));
    if (form.holes == 0)
        text += tr(form.crowded_edges == 0 ? to_translate(", closed") : to_translate(", no hole"));
    if (form.holes > 0)
        text += tr(form.holes == 1 ? to_translate(", 1 hole of {edges}")
                                   : to_translate(", {number} holes, the longest of {edges}"),
                   {{"number", form.holes}, {"edges", edges_of(form.longest_hole)}});
    if (form.crowded_edges > 0)
        text +=
            tr(", {edges} of three triangles or more", {{"edges", edges_of(form.crowded_edges)}});
    if (form.turned > 0)
        text += tr(", {triangles} turned over", {{"triangles", triangles_of(form.turned)}});
    if (form.one_sided > 0)
        text += tr(", {triangles} of a surface with only one side",
                   {{"triangles", triangles_of(form.one_sided)}});
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
    const std::string loss = loss_in_float(low, high);
    return tr("middle m {point}, longest side e {side}",
              {{"point",
                formatted("%.12g,%.12g,%.12g", middle.x + 0.0, middle.y + 0.0, middle.z + 0.0)},
               {"side", formatted("%.6g", longest)}}) +
           (loss.empty() ? ""
                         : "\n    " + tr("at risk with --precision float: {what}",
                                         {{"what", tr_text(loss)}}));
}

}  // namespace

std::string mesh_forms(const Scene& scene, const Warn& warn) {
    std::string lines;
    std::set<std::string> seen;
    for (const MeshRequest& named : scene.mesh_requests) {
        if (!seen.insert(named.file).second) continue;
        const Mesh mesh = read_named(named, warn, [&](const Warn& warn_of_line) {
            return load_mesh(path_of(named), warn_of_line, false);
        });
        const auto [triangles, vertices] = welded(mesh);
        lines += (seen.size() == 1 ? tr("with the meshes") + "\n  " : "  ") +
                 tr("{file}: {triangles} in {form}; {box}",
                    {{"file", one_line(named.file)},
                     {"triangles", triangles_of(mesh.triangles.size())},
                     {"form", form_line(form_of(triangles, vertices))},
                     {"box", box_line(mesh)}}) +
                 "\n";
    }
    return lines;
}

}  // namespace rt
