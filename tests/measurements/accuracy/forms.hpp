// All forms of intersecting each shape in this repository, with one signature.
#pragma once

#include "common/geometry/cone.hpp"
#include "common/geometry/cylinder.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/sphere.hpp"
#include "common/geometry/square.hpp"
#include "common/geometry/triangle.hpp"
#include "common/math/real.hpp"

#include <optional>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

/// The name of a program's precision in its output.
inline constexpr const char* precision_word = sizeof(Real) == 4 ? "float" : "double";

/// A formula, and its name in plots and tables, without a comma.
template <class Shape>
struct Form {
    const char* name;
    std::optional<Real> (*intersect)(const Ray& ray, const Shape& shape, Interval interval);
    const char* precision = precision_word;
};

}  // namespace RT_PRECISION

/// For each shape: the reference first, then the textbook's form, the unit of costs, then the
/// others.
template <class Shape>
[[nodiscard]] std::vector<Form<Shape>> forms_of(const Shape& shape);

/// Calls `study` with each shape's name and a shape of its kind.
template <class Study>
void for_every_shape(const Study& study) {
    study("sphere", Sphere{});
    study("plane", Plane{});
    study("triangle", Triangle{});
    study("square", Square{});
    study("cylinder", Cylinder{});
    study("cone", Cone{});
}

}  // namespace rt
