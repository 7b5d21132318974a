// The edges at which the triangles of a mesh meet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rt {

/// Three vertices for each triangle.
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Corner k of triangle t has the number 3t + k; so has the side from this corner to the next one.

/// The corner at which a side ends.
[[nodiscard]] constexpr std::uint32_t end_of(std::uint32_t side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

/// In place of a side, at an edge of one triangle.
inline constexpr std::uint32_t border = 0xffffffff;
/// In place of a side, at an edge of three triangles or more.
inline constexpr std::uint32_t crowded = 0xfffffffe;

/// Returns for each side the one of the other triangle at this edge; or border, or crowded.
[[nodiscard]] std::vector<std::uint32_t> other_sides(const Triangles& triangles,
                                                     std::size_t vertices);

/// Returns whether the two triangles at an edge run along it in opposite directions, as neighbors
/// do of which none is turned over.
[[nodiscard]] inline bool is_consistent(const Triangles& triangles, std::uint32_t side,
                                        std::uint32_t other) {
    return triangles[side / 3][side % 3] != triangles[other / 3][other % 3];
}

/// Returns a group for each corner, named by one of its corners. Two corners at a vertex are in one
/// group if consistent edges connect them for which `is_joined(side, other)` holds.
[[nodiscard]] std::vector<std::uint32_t> corner_groups(
    const Triangles& triangles, const std::vector<std::uint32_t>& others,
    const std::function<bool(std::uint32_t, std::uint32_t)>& is_joined);

/// The triangles to turn over so that all neighbors are consistent.
struct Orientation {
    std::vector<bool> is_turned;  ///< for each triangle; empty if none must be
    std::size_t turned = 0;       ///< triangles of parts that have two sides
    std::size_t one_sided = 0;    ///< triangles of parts that have one side, as a Möbius band has
};

/// Returns the triangles to turn over: in every part the fewer of them. In a part with one side
/// some neighbors remain inconsistent. Two triangles with the same corners are not neighbors.
[[nodiscard]] Orientation orientation_of(const Triangles& triangles,
                                         const std::vector<std::uint32_t>& others);

}  // namespace rt
