// Planes, and what the program needs of them (shape.hpp). Their stage defines `intersect` and
// `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// The points p with ⟨p − point, normal⟩ = 0.
struct Plane {
    Vec3 point;
    Vec3 normal{0, 1, 0};  ///< any non-zero length
};

}  // namespace RT_PRECISION

template <>
inline constexpr auto shape_record<Plane> = record_of("Plane", field("point", &Plane::point),
                                                      field("normal", &Plane::normal));

/// The shape transformed.
[[nodiscard]] inline Plane transformed(const Plane& plane, const Transform& transform) {
    return {.point = transformed(plane.point, transform),
            .normal = rotated(plane.normal, transform)};
}

/// The nearest point of the surface without its edges (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const Plane& plane, Vec3 point) {
    return geometry::bounded(geometry::onto_plane(point, plane.point, unit(plane.normal)),
                             largest_component(plane.point));
}

[[nodiscard]] inline Real distance_to_surface(Vec3 point, const Plane& plane) {
    return std::abs(dot(point - plane.point, unit(plane.normal)));
}

// Defined by the stage, in story.cpp and exact/.
const char* explain(PixelLog& log, const Ray& ray, const Plane& plane);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Plane& plane,
                                                  Interval interval);

}  // namespace rt
