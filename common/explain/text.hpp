// Values as text, with enough digits to be parsed as the same number.
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/shapes.hpp"
#include "common/geometry/transform.hpp"
#include "common/image/pixel.hpp"

#include <string>

namespace rt {

/// The shortest text that is parsed as the same number.
[[nodiscard]] std::string text(Real value);
[[nodiscard]] std::string text(Vec2 v);  ///< "(x, y)"
[[nodiscard]] std::string text(Vec3 v);  ///< "(x, y, z)"

/// C++ code that constructs the value, for use in a test: "Sphere{.center = {0, 0, -5}, …}".
[[nodiscard]] std::string code(Real value);
[[nodiscard]] std::string code(Vec3 v);
[[nodiscard]] std::string code(const Ray& ray);
[[nodiscard]] std::string code(Interval interval);
[[nodiscard]] std::string code(const Basis& basis);
[[nodiscard]] std::string code(const Sphere& sphere);
[[nodiscard]] std::string code(const Plane& plane);
[[nodiscard]] std::string code(const Triangle& triangle);
[[nodiscard]] std::string code(const Square& square);
[[nodiscard]] std::string code(const Cylinder& cylinder);
[[nodiscard]] std::string code(const Cone& cone);
[[nodiscard]] std::string code(const OrientedBox& box);
[[nodiscard]] std::string code(const BoundingBox& box);
[[nodiscard]] std::string code(const Transform& transform);

}  // namespace rt
