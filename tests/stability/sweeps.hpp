// Rays and shapes at the extremes: each sweep takes one thing there, uniform over its decades, and
// the last one several at once.
#pragma once

#include "common/geometry/cone.hpp"
#include "common/geometry/cylinder.hpp"
#include "common/geometry/oriented_box.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/sphere.hpp"
#include "common/geometry/square.hpp"
#include "common/geometry/triangle.hpp"
#include "tests/kit/random.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rt {

enum class Sweep {
    moderate,  ///< nothing: shapes of size 1, rays from 2 to 10 away
    distance,  ///< from 1 to 1e8 away
    grazing,   ///< past a silhouette, or along a face, by 1e-1 to 1e-12
    offset,    ///< everything moved by 1 to 1e8
    scale,     ///< everything 1e-20 to 1e20 times as large; in float 1e-15 to 1e15
    speed,     ///< directions of length 1e-18 to 1e18
    border,    ///< aimed at an edge or a rim, and 1e-1 to 1e-12 beside it
    point,     ///< aimed at a corner or an apex, and 1e-1 to 1e-12 beside it
    parallel,  ///< the same angles from the axis of a cylinder, from a line on a cone
    sliver,    ///< triangles 1e-1 to 1e-8 as wide as long
    surface,   ///< from the surface, to rounding, or near it; half of them along it
    range,     ///< in double: 1e-140 to 1e140 times as large, directions 1e-150 to 1e150 long
    mixed,     ///< several of these at once, sizes 1e-6 to 1e6 in one shape, or whole numbers
};

[[nodiscard]] std::string name(Sweep sweep);

/// The number in an environment variable, if it is set.
[[nodiscard]] std::uint64_t number_from(const char* variable, std::uint64_t otherwise);

template <class Shape>
struct Case {
    Ray ray;
    Shape shape;
    Interval interval = {};
};

// Each template is instantiated for the seven shapes of the exercises.

/// The sweeps that take a part of this shape to an extreme, but for `range`.
template <class Shape>
[[nodiscard]] std::vector<Sweep> sweeps_of();

/// Draws one case of the sweep. Returns by how much the ray is meant to pass a silhouette, or to
/// lean on a face; 0 if it is not.
template <class Shape>
Real draw(Random& random, Sweep sweep, Case<Shape>& drawn);

/// An interval that ends or begins a few ulps from there, where a decision is hardest.
[[nodiscard]] Interval around(Random& random, Real t);

}  // namespace rt
