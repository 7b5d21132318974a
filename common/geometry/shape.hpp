// The functions that the program needs of each kind of shape. The kind has a file of its own, such
// as sphere.hpp, with its struct and these functions; README.md lists the other places that a new
// kind needs.
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/bounding_sphere.hpp"
#include "common/geometry/projection.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/transform.hpp"

#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace rt {

// Types of other rooms, for the functions that a kind's file declares and its stage defines.
class PixelLog;  // common/explain
inline namespace RT_PRECISION {
struct ExactRoot;  // common/exact
}

/// A field of a struct: its name, and the pointer to the member.
template <class Owner, class Part>
struct Field {
    const char* name;
    Part Owner::*member;
};

/// The name and the fields of a struct.
template <class... Fields>
struct Record {
    const char* name;
    std::tuple<Fields...> fields;
};

template <class Owner, class Part>
constexpr Field<Owner, Part> field(const char* name, Part Owner::*member) {
    return {name, member};
}

/// A stand-in for the value of any field, in unevaluated expressions only.
struct AnyField {
    template <class T>
    operator T() const;
};

/// Returns whether the aggregate Owner can be initialized by a value for each of that many fields.
template <class Owner, std::size_t... Is>
constexpr bool has_fields(std::index_sequence<Is...> /*count*/) {
    return requires {
        Owner{(void(Is), AnyField())...};
    };
}

/// The name and all fields of Owner. A field of the struct that is missing here is an error,
/// because it would be lost between a suite and its worker.
template <class Owner, class... Parts>
constexpr Record<Field<Owner, Parts>...> record_of(const char* name,
                                                   Field<Owner, Parts>... fields) {
    static_assert(!has_fields<Owner>(std::make_index_sequence<sizeof...(fields) + 1>()),
                  "the struct has a field that its record lacks");
    return {name, {fields...}};
}

/// The fields of a kind of shape, in their order; nothing for other types.
template <class Shape>
inline constexpr auto shape_record = nullptr;

/// The members of every kind of shape.
template <class T>
concept KindOfShape = requires(const T& shape, const Transform& transform, Vec3 point) {
    shape_record<T>.fields;  // for its text and its bytes
    { transformed(shape, transform) } -> std::same_as<T>;
    { snapped_to(shape, point) } -> std::same_as<PointWithError>;  // projection.hpp
    // For checks of a scene before it is rendered, from here on.
    { distance_to_surface(point, shape) } -> std::same_as<Real>;
};

/// The additional members of every kind of shape except the plane.
template <class T>
concept BoundedKindOfShape = KindOfShape<T> && requires(const T& shape, Vec2 place) {
    { bounds(shape) } -> std::same_as<BoundingBox>;  // padded, as the bounding sphere
    { bounding_sphere(shape) } -> std::same_as<BoundingSphere>;
    { shape == shape } -> std::same_as<bool>;  // for copies in a hierarchy
    // For checks of a scene before it is rendered, from here on.
    { smallest_size(shape) } -> std::same_as<Real>;
    { surface_point(shape, place) } -> std::same_as<Vec3>;
};

}  // namespace rt
