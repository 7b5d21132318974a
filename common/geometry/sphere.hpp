// Spheres, and what the program needs of them (shape.hpp). Their stage defines `intersect` and
// `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

struct Sphere {
    Vec3 center;
    Real radius = 1;  ///< positive

    bool operator==(const Sphere&) const = default;
};

}  // namespace RT_PRECISION

template <>
inline constexpr auto shape_record<Sphere> = record_of("Sphere", field("center", &Sphere::center),
                                                       field("radius", &Sphere::radius));

/// The shape transformed.
[[nodiscard]] inline Sphere transformed(const Sphere& sphere, const Transform& transform) {
    return {.center = transformed(sphere.center, transform),
            .radius = transform.scale * sphere.radius};
}

/// The padded bounding box, in units of the scene.
[[nodiscard]] inline BoundingBox bounds(const Sphere& sphere) {
    return geometry::padded(geometry::around(sphere.center, Vec3(sphere.radius)));
}

/// The padded bounding sphere, in units of the scene.
[[nodiscard]] inline BoundingSphere bounding_sphere(const Sphere& sphere) {
    return geometry::padded(BoundingSphere{.center = sphere.center, .radius = sphere.radius});
}

/// The nearest point of the surface without its edges (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const Sphere& sphere, Vec3 point) {
    const auto& [center, radius] = sphere;
    const Vec3 outward = point - center;
    if (outward == Vec3(0)) return geometry::bounded(point, radius);
    return geometry::bounded(center + radius * unit(outward), largest_component(center) + radius);
}

/// The smallest size: a displacement is compared to it.
[[nodiscard]] inline Real smallest_size(const Sphere& sphere) {
    return sphere.radius;
}

/// A point of the surface: equal areas of the unit square map to equal areas of the surface.
[[nodiscard]] inline Vec3 surface_point(const Sphere& sphere, Vec2 place) {
    const Real z = 1 - 2 * place.y;
    const Real across = std::sqrt(glm::max(1 - z * z, Real(0)));
    const Real angle = 2 * pi * place.x;
    return sphere.center +
           sphere.radius * Vec3(across * std::cos(angle), across * std::sin(angle), z);
}

[[nodiscard]] inline Real distance_to_surface(Vec3 point, const Sphere& sphere) {
    return std::abs(length(point - sphere.center) - sphere.radius);
}

// Defined by the stage, in story.cpp and exact/.
const char* explain(PixelLog& log, const Ray& ray, const Sphere& sphere);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Sphere& sphere,
                                                  Interval interval);

}  // namespace rt
