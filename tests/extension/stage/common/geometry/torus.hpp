// Tori, and what the program needs of them (shape.hpp). Their stage defines `intersect` and
// `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// A tube around a circle: (|p|² + R² − r²)² = 4 R² (x² + y²), where 0 < r < R.
struct Torus {
    Vec3 center;
    Vec3 axis{0, 1, 0};      ///< unit length, perpendicular to the plane of the circle
    Real radius = 1;         ///< R, of the circle
    Real tube = Real(0.25);  ///< r, of the tube

    bool operator==(const Torus&) const = default;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

template <>
inline constexpr auto shape_record<Torus> = record_of("Torus", field("center", &Torus::center),
                                                      field("axis", &Torus::axis),
                                                      field("radius", &Torus::radius),
                                                      field("tube", &Torus::tube));

/// The shape transformed.
[[nodiscard]] inline Torus transformed(const Torus& torus, const Transform& transform) {
    return {.center = transformed(torus.center, transform),
            .axis = rotated(torus.axis, transform),
            .radius = transform.scale * torus.radius,
            .tube = transform.scale * torus.tube};
}

/// The padded bounding box, in units of the scene.
[[nodiscard]] inline BoundingBox bounds(const Torus& torus) {
    const Vec3 reach = geometry::reach_of_circle(torus.axis, torus.radius) + Vec3(torus.tube);
    return geometry::padded(geometry::around(torus.center, reach));
}

/// The padded bounding sphere, in units of the scene.
[[nodiscard]] inline BoundingSphere bounding_sphere(const Torus& torus) {
    return geometry::padded(
        BoundingSphere{.center = torus.center, .radius = torus.radius + torus.tube});
}

/// The point of the circle that is nearest to the point; on the axis, the point itself.
[[nodiscard]] inline Vec3 nearest_of_circle(const Torus& torus, Vec3 point) {
    const Vec3 v = point - torus.center;
    const Vec3 across = v - dot(v, torus.axis) * torus.axis;
    return across == Vec3(0) ? point : torus.center + torus.radius * unit(across);
}

/// The nearest point of the surface (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const Torus& torus, Vec3 point) {
    const Real size = largest_component(torus.center) + torus.radius + torus.tube;
    const Vec3 in_tube = nearest_of_circle(torus, point);
    if (in_tube == point) return geometry::bounded(point, size);
    return geometry::bounded(in_tube + torus.tube * unit(point - in_tube), size);
}

/// The smallest size: a displacement is compared to it.
[[nodiscard]] inline Real smallest_size(const Torus& torus) {
    return torus.tube;
}

/// A point of the surface: equal areas of the unit square map to equal areas of the surface.
[[nodiscard]] inline Vec3 surface_point(const Torus& torus, Vec2 place) {
    // The area up to the angle around the tube is proportional to angle + (r / R) sin(angle).
    const Real share = torus.tube / torus.radius;
    Real angle = 2 * pi * place.y;
    for (int i = 0; i < 8; ++i)
        angle -=
            (angle + share * std::sin(angle) - 2 * pi * place.y) / (1 + share * std::cos(angle));
    const Vec3 outward = geometry::perpendicular(torus.axis, place.x);
    return torus.center + (torus.radius + torus.tube * std::cos(angle)) * outward +
           torus.tube * std::sin(angle) * torus.axis;
}

/// The distance from the point to the surface.
[[nodiscard]] inline Real distance_to_surface(Vec3 point, const Torus& torus) {
    const geometry::Meridian at = geometry::meridian(point - torus.center, torus.axis);
    return std::abs(std::hypot(at.across - torus.radius, at.along) - torus.tube);
}

// Defined by the stage, in story.cpp.
const char* explain(PixelLog& log, const Ray& ray, const Torus& torus);

}  // namespace rt
