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

namespace {

/// Turns the triangles of one part after the other.
class Orienting {
public:
    Orienting(const Triangles& triangles, const std::vector<std::uint32_t>& others)
        : triangles_(triangles), others_(others), is_seen_(triangles.size()) {
        result_.is_turned.resize(triangles.size());
    }

    [[nodiscard]] Orientation run() {
        for (std::uint32_t seed = 0; seed < triangles_.size(); ++seed)
            if (!is_seen_[seed]) orient_part(seed);
        return std::move(result_);
    }

    /// Returns whether two neighbors run along this side in the same direction.
    [[nodiscard]] bool is_wrong(std::uint32_t side) const {
        return has_neighbor(side) && !is_consistent(triangles_, side, others_[side]);
    }

private:
    [[nodiscard]] bool has_neighbor(std::uint32_t side) const {
        const std::uint32_t other = others_[side];
        return other < crowded && opposite(side) != opposite(other);
    }

    /// The corner that is not on the side.
    [[nodiscard]] std::uint32_t opposite(std::uint32_t side) const {
        return triangles_[side / 3][(side + 2) % 3];
    }

    void orient_part(std::uint32_t seed) {
        is_seen_[seed] = true;
        part_.assign(1, seed);
        auto& is_turned = result_.is_turned;
        std::size_t turned = 0;
        bool has_two_sides = true;
        for (std::size_t i = 0; i < part_.size(); ++i) {
            const std::uint32_t triangle = part_[i];
            for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                if (!has_neighbor(side)) continue;
                const std::uint32_t other = others_[side] / 3;
                const bool must_turn = is_turned[triangle] != is_wrong(side);
                if (is_seen_[other]) {
                    has_two_sides = has_two_sides && is_turned[other] == must_turn;
                    continue;
                }
                is_seen_[other] = true;
                is_turned[other] = must_turn;
                turned += must_turn;
                part_.push_back(other);
            }
        }
        const bool fewer = 2 * turned <= part_.size();
        if (!fewer)
            for (const std::uint32_t triangle : part_) is_turned[triangle] = !is_turned[triangle];
        if (has_two_sides)
            result_.turned += fewer ? turned : part_.size() - turned;
        else
            result_.one_sided += part_.size();
    }

    const Triangles& triangles_;
    const std::vector<std::uint32_t>& others_;
    std::vector<bool> is_seen_;
    std::vector<std::uint32_t> part_;  ///< in the order in which its triangles are reached
    Orientation result_;
};

}  // namespace

Orientation orientation_of(const Triangles& triangles, const std::vector<std::uint32_t>& others) {
    Orienting orienting(triangles, others);
    for (std::uint32_t side = 0; side < others.size(); ++side)
        if (orienting.is_wrong(side)) return orienting.run();
    return {};
}

}  // namespace rt
