// Limits of the errors of the references, in the measures of judge.hpp: those of
// docs/reference/stability.md, derived in docs/reference/error_bounds.md.
#pragma once

#include "common/geometry/cone.hpp"
#include "common/geometry/cylinder.hpp"
#include "common/geometry/oriented_box.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/sphere.hpp"
#include "common/geometry/square.hpp"
#include "common/geometry/triangle.hpp"

#include <limits>

namespace rt {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

struct Bars {
    double off = unbounded;
    double band = unbounded;
    double ulps = unbounded;
};

/// What is promised; and where nothing is derived, a little more than the largest error that a
/// search found: the bands of squares, cylinders, cones and boxes, and the off of cones.
template <class Shape>
inline constexpr Bars promised = {};
template <>
inline constexpr Bars promised<Sphere> = {.off = 12, .band = 5};
template <>
inline constexpr Bars promised<Plane> = {.ulps = 4};
template <>
inline constexpr Bars promised<Triangle> = {.off = 34, .band = 8};
template <>
inline constexpr Bars promised<Square> = {.off = 15, .band = 3};
template <>
inline constexpr Bars promised<Cylinder> = {.off = 31, .band = 4};
template <>
inline constexpr Bars promised<Cone> = {.off = 14, .band = 6};
template <>
inline constexpr Bars promised<OrientedBox> = {.off = 34, .band = 4};

/// Returns whether the program's kernels are those of `--precision exact`.
[[nodiscard]] bool are_certified();

/// What is promised for these kernels: no wrong decision of a certified one, and t within the
/// largest distance that a search found (docs/reference/stability.md); the proved bounds are
/// larger.
template <class Shape>
[[nodiscard]] Bars bars_of() {
    return are_certified() ? Bars{.band = 0, .ulps = 11} : promised<Shape>;
}

}  // namespace rt
