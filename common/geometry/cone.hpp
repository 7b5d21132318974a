// Open cones, and what the program needs of them (shape.hpp). Their stage defines `intersect` and
// `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// The lateral surface of one nappe of a cone without base: x² + y² = (radius / height)² z²,
/// 0 ≤ z ≤ height (MRT §8, with its coefficient corrected). The cone opens along the axis.
struct Cone {
    Vec3 apex;
    Vec3 axis{0, 1, 0};  ///< unit length, from the apex into the cone
    Real radius = 1;     ///< radius at distance `height` from the apex
    Real height = 1;

    bool operator==(const Cone&) const = default;
};

}  // namespace RT_PRECISION

template <>
inline constexpr auto shape_record<Cone> = record_of("Cone", field("apex", &Cone::apex),
                                                     field("axis", &Cone::axis),
                                                     field("radius", &Cone::radius),
                                                     field("height", &Cone::height));

/// The shape transformed.
[[nodiscard]] inline Cone transformed(const Cone& cone, const Transform& transform) {
    return {.apex = transformed(cone.apex, transform),
            .axis = rotated(cone.axis, transform),
            .radius = transform.scale * cone.radius,
            .height = transform.scale * cone.height};
}

/// The padded bounding box, in units of the scene.
[[nodiscard]] inline BoundingBox bounds(const Cone& cone) {
    const BoundingBox rim = geometry::around(cone.apex + cone.height * cone.axis,
                                             geometry::reach_of_circle(cone.axis, cone.radius));
    return geometry::padded(merged(rim, cone.apex));
}

/// The padded bounding sphere, in units of the scene.
[[nodiscard]] inline BoundingSphere bounding_sphere(const Cone& cone) {
    const auto& [apex, axis, radius, height] = cone;
    // The sphere through the apex and the rim; for a blunt cone the sphere around the rim, which
    // contains the apex.
    const Real slant = std::hypot(radius, height);
    const Real from_apex = radius < height ? slant / 2 * (slant / height) : height;
    return geometry::padded(
        BoundingSphere{.center = apex + from_apex * axis, .radius = glm::max(radius, from_apex)});
}

/// The nearest point of the surface without its edges (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const Cone& cone, Vec3 point) {
    const auto& [apex, axis, radius, height] = cone;
    const Real size = largest_component(apex) + radius + height;
    const Real z = dot(point - apex, axis);
    const Vec3 across = point - apex - z * axis;
    if (across == Vec3(0)) return geometry::bounded(point, size);
    // Projection onto the generator line from the apex, in the half-plane through the axis and the
    // point.
    const Vec3 outward = unit(across);
    const Vec3 side = unit(height * axis + radius * outward);
    return geometry::bounded(apex + dot(point - apex, side) * side, size);
}

/// The smallest size: a displacement is compared to it.
[[nodiscard]] inline Real smallest_size(const Cone& cone) {
    return glm::min(cone.radius, cone.height);
}

/// A point of the surface: equal areas of the unit square map to equal areas of the surface.
[[nodiscard]] inline Vec3 surface_point(const Cone& cone, Vec2 place) {
    const Vec3 to_rim =
        cone.height * cone.axis + cone.radius * geometry::perpendicular(cone.axis, place.x);
    return cone.apex + std::sqrt(place.y) * to_rim;
}

[[nodiscard]] inline Real distance_to_surface(Vec3 point, const Cone& cone) {
    const geometry::Meridian at = geometry::meridian(point - cone.apex, cone.axis);
    return geometry::distance_to_segment(Vec3(at.across, at.along, 0), Vec3(0),
                                         Vec3(cone.radius, cone.height, 0));
}

// Defined by the stage, in story.cpp and exact/.
const char* explain(PixelLog& log, const Ray& ray, const Cone& cone);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Cone& cone,
                                                  Interval interval);

}  // namespace rt
