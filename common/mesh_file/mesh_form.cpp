#include "common/mesh_file/mesh_form.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rt {

namespace {

/// Counts the closed ways along open sides, of triangles of which none is turned over; what has one
/// side is cut open. A corner group is a fan: an open one has one open side that starts there, and
/// one that ends there. So two fans that touch in a vertex, and crowded edges, are cut open too.
void count_holes(const Triangles& triangles, const std::vector<std::uint32_t>& others,
                 MeshForm& form) {
    const auto is_open = [&](std::uint32_t side) {
        return others[side] >= crowded || !is_consistent(triangles, side, others[side]);
    };
    const auto fans = corner_groups(triangles, others, [](auto, auto) { return true; });
    std::vector<std::uint32_t> open_side(fans.size());  // the one that starts at the fan
    for (std::uint32_t side = 0; side < fans.size(); ++side)
        if (is_open(side)) open_side[fans[side]] = side;
    std::vector<bool> is_seen(fans.size());
    for (std::uint32_t start = 0; start < fans.size(); ++start) {
        if (!is_open(start) || is_seen[start]) continue;
        std::size_t length = 0;
        for (std::uint32_t at = start; !is_seen[at]; at = open_side[fans[end_of(at)]], ++length)
            is_seen[at] = true;
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
    count_holes(consistent, others, form);
    return form;
}

}  // namespace rt
