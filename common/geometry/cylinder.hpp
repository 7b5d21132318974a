// Open cylinders, and what the program needs of them (shape.hpp). Their stage defines `intersect`
// and `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// The lateral surface of a cylinder without caps: distance `radius` from the axis,
/// |z| ≤ height / 2 (MRT §7).
struct Cylinder {
    Vec3 center;         ///< midpoint of the axis
    Vec3 axis{0, 1, 0};  ///< unit length
    Real radius = 1;
    Real height = 1;

    bool operator==(const Cylinder&) const = default;
};

}  // namespace RT_PRECISION

template <>
inline constexpr auto shape_record<Cylinder> = record_of("Cylinder",
                                                         field("center", &Cylinder::center),
                                                         field("axis", &Cylinder::axis),
                                                         field("radius", &Cylinder::radius),
                                                         field("height", &Cylinder::height));

/// The shape transformed.
[[nodiscard]] inline Cylinder transformed(const Cylinder& cylinder, const Transform& transform) {
    return {.center = transformed(cylinder.center, transform),
            .axis = rotated(cylinder.axis, transform),
            .radius = transform.scale * cylinder.radius,
            .height = transform.scale * cylinder.height};
}

/// The padded bounding box, in units of the scene.
[[nodiscard]] inline BoundingBox bounds(const Cylinder& cylinder) {
    const Vec3 reach = cylinder.height / 2 * abs(cylinder.axis) +
                       geometry::reach_of_circle(cylinder.axis, cylinder.radius);
    return geometry::padded(geometry::around(cylinder.center, reach));
}

/// The padded bounding sphere, in units of the scene.
[[nodiscard]] inline BoundingSphere bounding_sphere(const Cylinder& cylinder) {
    return geometry::padded(BoundingSphere{
        .center = cylinder.center, .radius = std::hypot(cylinder.radius, cylinder.height / 2)});
}

/// The nearest point of the surface without its edges (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const Cylinder& cylinder, Vec3 point) {
    const auto& [center, axis, radius, height] = cylinder;
    const Real size = largest_component(center) + radius + height;
    const Vec3 along = dot(point - center, axis) * axis;
    const Vec3 across = point - center - along;
    if (across == Vec3(0)) return geometry::bounded(point, size);
    return geometry::bounded(center + along + radius * unit(across), size);
}

/// The smallest size: a displacement is compared to it.
[[nodiscard]] inline Real smallest_size(const Cylinder& cylinder) {
    return glm::min(cylinder.radius, cylinder.height);
}

/// A point of the surface: equal areas of the unit square map to equal areas of the surface.
[[nodiscard]] inline Vec3 surface_point(const Cylinder& cylinder, Vec2 place) {
    return cylinder.center + (place.y - Real(0.5)) * cylinder.height * cylinder.axis +
           cylinder.radius * geometry::perpendicular(cylinder.axis, place.x);
}

[[nodiscard]] inline Real distance_to_surface(Vec3 point, const Cylinder& cylinder) {
    const geometry::Meridian at = geometry::meridian(point - cylinder.center, cylinder.axis);
    return std::hypot(at.across - cylinder.radius,
                      glm::max(std::abs(at.along) - cylinder.height / 2, Real(0)));
}

// Defined by the stage, in story.cpp and exact/.
const char* explain(PixelLog& log, const Ray& ray, const Cylinder& cylinder);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Cylinder& cylinder,
                                                  Interval interval);

}  // namespace rt
