// Triangles, and what the program needs of them (shape.hpp). Their stage defines `intersect` and
// `normal`.
#pragma once

#include "common/geometry/shape.hpp"
#include "common/geometry/shape_formulas.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

/// A triangle including its edges and vertices. The normal (b − a) × (c − a) points to the side
/// from which a, b, c are counterclockwise.
struct Triangle {
    Vec3 a;
    Vec3 b;
    Vec3 c;

    bool operator==(const Triangle&) const = default;
};

}  // namespace RT_PRECISION

template <>
inline constexpr auto shape_record<Triangle> = record_of("Triangle", field("a", &Triangle::a),
                                                         field("b", &Triangle::b),
                                                         field("c", &Triangle::c));

/// The shape transformed.
[[nodiscard]] inline Triangle transformed(const Triangle& triangle, const Transform& transform) {
    return {.a = transformed(triangle.a, transform),
            .b = transformed(triangle.b, transform),
            .c = transformed(triangle.c, transform)};
}

/// The padded bounding box, in units of the scene.
[[nodiscard]] inline BoundingBox bounds(const Triangle& triangle) {
    return geometry::padded(
        merged(merged(merged(BoundingBox{}, triangle.a), triangle.b), triangle.c));
}

/// The padded bounding sphere, in units of the scene.
[[nodiscard]] inline BoundingSphere bounding_sphere(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 center = a / Real(3) + b / Real(3) + c / Real(3);
    const Real radius =
        glm::max(length(a - center), glm::max(length(b - center), length(c - center)));
    return geometry::padded(BoundingSphere{.center = center, .radius = radius});
}

/// The nearest point of the surface without its edges (projection.hpp).
[[nodiscard]] inline PointWithError snapped_to(const Triangle& triangle, Vec3 point) {
    const auto& [a, b, c] = triangle;
    // For a sliver, the plain cross product has too few accurate digits to stay in the plane.
    const Vec3 normal = compensated_cross(b - a, c - a);
    const Real size =
        glm::max(largest_component(a), glm::max(largest_component(b), largest_component(c)));
    if (normal == Vec3(0)) return geometry::bounded(point, size);
    return geometry::bounded(geometry::onto_plane(point, a, unit(normal)), size);
}

/// The smallest height: a displacement is compared to it; 0 without an area.
[[nodiscard]] inline Real smallest_size(const Triangle& triangle) {
    // Twice the area divided by the longest side: the smallest height.
    const Vec3 ab = triangle.b - triangle.a;
    const Vec3 ac = triangle.c - triangle.a;
    const Real longest = glm::max(length(ab), glm::max(length(ac), length(ac - ab)));
    return longest > 0 ? length(cross(ab, ac)) / longest : 0;
}

/// A point of the surface: equal areas of the unit square map to equal areas of the surface.
[[nodiscard]] inline Vec3 surface_point(const Triangle& triangle, Vec2 place) {
    if (place.x + place.y > 1) place = Vec2(1) - place;
    const auto& [a, b, c] = triangle;
    return a + place.x * (b - a) + place.y * (c - a);
}

[[nodiscard]] inline Real distance_to_surface(Vec3 point, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 n = cross(b - a, c - a);
    const bool inside = dot(cross(b - a, point - a), n) >= 0 &&
                        dot(cross(c - b, point - b), n) >= 0 &&
                        dot(cross(a - c, point - c), n) >= 0;
    if (inside && n != Vec3(0)) return std::abs(dot(point - a, unit(n)));
    const Real to_ab = geometry::distance_to_segment(point, a, b);
    const Real to_bc = geometry::distance_to_segment(point, b, c);
    const Real to_ca = geometry::distance_to_segment(point, c, a);
    return glm::min(to_ab, glm::min(to_bc, to_ca));
}

// Defined by the stage, in story.cpp and exact/.
const char* explain(PixelLog& log, const Ray& ray, const Triangle& triangle);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Triangle& triangle,
                                                  Interval interval);

}  // namespace rt
