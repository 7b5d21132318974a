#include "common/geometry/mesh_edges.hpp"

#include <algorithm>
#include <utility>

namespace rt {

namespace {

/// A side of a triangle, in the list of its lower vertex.
struct Side {
    std::uint32_t higher;  ///< vertex
    std::uint32_t number;
};

/// The sides sorted by their lower vertex, of which the first is at begin[vertex].
struct SortedSides {
    std::vector<std::uint32_t> begin;
    std::vector<Side> sides;
};

SortedSides sorted_sides(const Triangles& triangles, std::size_t vertices) {
    SortedSides sorted;
    auto& [begin, sides] = sorted;
    begin.resize(vertices + 2);
    for (const auto& [a, b, c] : triangles) {
        ++begin[std::min(a, b) + 2];
        ++begin[std::min(b, c) + 2];
        ++begin[std::min(c, a) + 2];
    }
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    sides.resize(3 * triangles.size());
    std::uint32_t number = 0;
    for (const auto& corners : triangles) {
        for (std::size_t k = 0; k < 3; ++k, ++number) {
            const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
            sides[begin[low + 1]++] = {.higher = high, .number = number};
        }
    }
    return sorted;
}

/// The root of the corner's group. Halves the path to it.
std::uint32_t root(std::vector<std::uint32_t>& parents, std::uint32_t corner) {
    while (parents[corner] != corner) corner = parents[corner] = parents[parents[corner]];
    return corner;
}

void unite(std::vector<std::uint32_t>& parents, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t root_a = root(parents, a);
    const std::uint32_t root_b = root(parents, b);
    parents[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

}  // namespace

std::vector<std::uint32_t> other_sides(const Triangles& triangles, std::size_t vertices) {
    auto [begin, sides] = sorted_sides(triangles, vertices);
    std::vector<std::uint32_t> others(sides.size(), border);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const auto first = sides.begin() + begin[vertex];
        const auto last = sides.begin() + begin[vertex + 1];
        std::sort(first, last, [](Side a, Side b) { return a.higher < b.higher; });
        for (auto at = first; at != last;) {
            const auto end =
                std::find_if(at, last, [=](Side side) { return side.higher != at->higher; });
            if (end - at == 2) {
                others[at[0].number] = at[1].number;
                others[at[1].number] = at[0].number;
            } else if (end - at > 2) {
                for (auto side = at; side != end; ++side) others[side->number] = crowded;
            }
            at = end;
        }
    }
    return others;
}

std::vector<std::uint32_t> corner_groups(
    const Triangles& triangles, const std::vector<std::uint32_t>& others,
    const std::function<bool(std::uint32_t, std::uint32_t)>& is_joined) {
    std::vector<std::uint32_t> groups(others.size());
    for (std::uint32_t i = 0; i < groups.size(); ++i) groups[i] = i;
    for (std::uint32_t side = 0; side < others.size(); ++side) {
        const std::uint32_t other = others[side];
        if (other >= crowded || other < side || !is_consistent(triangles, side, other) ||
            !is_joined(side, other))
            continue;
        unite(groups, side, end_of(other));
        unite(groups, end_of(side), other);
    }
    for (std::uint32_t i = 0; i < groups.size(); ++i) groups[i] = root(groups, i);
    return groups;
}

std::vector<bool> turned_triangles(const Triangles& triangles,
                                   const std::vector<std::uint32_t>& others) {
    const auto is_wrong = [&](std::uint32_t side) {
        return others[side] < crowded && !is_consistent(triangles, side, others[side]);
    };
    std::uint32_t side = 0;
    while (side < others.size() && !is_wrong(side)) ++side;
    if (side == others.size()) return {};
    std::vector<bool> is_turned(triangles.size());
    std::vector<bool> is_seen(triangles.size());
    std::vector<std::uint32_t> part;  // in the order in which its triangles are reached
    for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
        if (is_seen[seed]) continue;
        is_seen[seed] = true;
        part.assign(1, seed);
        std::size_t turned = 0;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::uint32_t triangle = part[i];
            for (std::uint32_t k = 3 * triangle; k < 3 * triangle + 3; ++k) {
                const std::uint32_t other = others[k];
                if (other >= crowded || is_seen[other / 3]) continue;
                is_seen[other / 3] = true;
                is_turned[other / 3] = is_turned[triangle] != is_wrong(k);
                turned += is_turned[other / 3];
                part.push_back(other / 3);
            }
        }
        if (2 * turned > part.size())
            for (const std::uint32_t triangle : part) is_turned[triangle] = !is_turned[triangle];
    }
    return is_turned;
}

}  // namespace rt
