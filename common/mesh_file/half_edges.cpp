#include "common/mesh_file/half_edges.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#ifdef RAYSTEPS_HOLES
#include <dlfcn.h>
#endif

namespace rt {

namespace {

#ifdef RAYSTEPS_HOLES
/// The function of the library of that name, which is loaded at the first call.
decltype(raysteps_count_holes)* hole_counter() {
    void* const library = dlopen(RAYSTEPS_HOLES, RTLD_NOW);
    void* const function = library == nullptr ? nullptr : dlsym(library, "raysteps_count_holes");
    if (function == nullptr) throw std::runtime_error(dlerror());
    return reinterpret_cast<decltype(raysteps_count_holes)*>(function);
}
#else
constexpr auto hole_counter() {
    return raysteps_count_holes;
}
#endif

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
    const auto groups = corner_groups(consistent, others, [](auto, auto) { return true; });
    hole_counter()(groups, form);
    return form;
}

}  // namespace rt
