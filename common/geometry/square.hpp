// Squares, and what the program needs of them (shape.hpp). Their stage defines `intersect` and
// `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// |x| ≤ side / 2 and |y| ≤ side / 2 in object space (MRT §6). It rotates with its basis.
struct Square {
    Vec3 center;
    Basis basis;  ///< x and y along the sides, z is the normal
    Real side = 1;
    bool one_sided = false;  ///< visible only from the side of its normal (HAI)

    bool operator==(const Square&) const = default;
};

}  // namespace RT_PRECISION

template <>
inline constexpr auto shape_record<Square> = record_of("Square", field("center", &Square::center),
                                                       field("basis", &Square::basis),
                                                       field("side", &Square::side),
                                                       field("one_sided", &Square::one_sided));

/// The shape transformed.
[[nodiscard]] inline Square transformed(const Square& square, const Transform& transform) {
    return {.center = transformed(square.center, transform),
            .basis = rotated(square.basis, transform),
            .side = transform.scale * square.side,
            .one_sided = square.one_sided};
}

/// The padded bounding box, in units of the scene.
[[nodiscard]] inline BoundingBox bounds(const Square& square) {
    const Vec3 reach = square.side / 2 * (abs(square.basis.x) + abs(square.basis.y));
    return geometry::padded(geometry::around(square.center, reach));
}

/// The padded bounding sphere, in units of the scene.
[[nodiscard]] inline BoundingSphere bounding_sphere(const Square& square) {
    return geometry::padded(
        BoundingSphere{.center = square.center, .radius = square.side / std::sqrt(Real(2))});
}

/// The nearest point of the surface without its edges (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const Square& square, Vec3 point) {
    return geometry::bounded(geometry::onto_plane(point, square.center, square.basis.z),
                             largest_component(square.center) + square.side);
}

/// The smallest size: a displacement is compared to it.
[[nodiscard]] inline Real smallest_size(const Square& square) {
    return square.side;
}

/// A point of the surface: equal areas of the unit square map to equal areas of the surface.
[[nodiscard]] inline Vec3 surface_point(const Square& square, Vec2 place) {
    const Vec2 from_middle = place - Vec2(Real(0.5));
    return square.center +
           square.side * (from_middle.x * square.basis.x + from_middle.y * square.basis.y);
}

[[nodiscard]] inline Real distance_to_surface(Vec3 point, const Square& square) {
    const Vec3 from_center = point - square.center;
    const auto beyond = [&](Vec3 axis) {
        return glm::max(std::abs(dot(from_center, axis)) - square.side / 2, Real(0));
    };
    return length(
        Vec3(beyond(square.basis.x), beyond(square.basis.y), dot(from_center, square.basis.z)));
}

// Defined by the stage, in story.cpp and exact/.
const char* explain(PixelLog& log, const Ray& ray, const Square& square);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Square& square,
                                                  Interval interval);

}  // namespace rt
