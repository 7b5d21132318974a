// Values as text, with enough digits to be parsed as the same number.
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/shape.hpp"
#include "common/geometry/transform.hpp"
#include "common/image/pixel.hpp"

#include <string>
#include <tuple>
#include <type_traits>

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
[[nodiscard]] std::string code(const BoundingBox& box);
[[nodiscard]] std::string code(const Transform& transform);

/// Any kind of shape. A flag that is not set is left out.
template <KindOfShape Shape>
[[nodiscard]] std::string code(const Shape& shape) {
    std::string fields;
    const auto append = [&fields](const char* name, const auto& value) {
        std::string text;
        if constexpr (std::is_same_v<decltype(value), const bool&>)
            text = value ? "true" : "";
        else
            text = code(value);
        if (!text.empty())
            fields += std::string(fields.empty() ? "." : ", .") + name + " = " + text;
    };
    std::apply([&](const auto&... field) { (append(field.name, shape.*field.member), ...); },
               shape_record<Shape>.fields);
    return std::string(shape_record<Shape>.name) + "{" + fields + "}";
}

}  // namespace rt
