// Points brought back onto the surface that they were computed to be on.
//
// A hit's point o + t d is off by what t and o are off, which grows with the distance of the eye.
// Moved to the nearest point of the shape it is off by a few roundings of the shape's own
// coordinates, and then a ray may leave it from a distance that is known to be enough (stage 10).
#pragma once

#include "common/shapes.hpp"

namespace rt::inline RT_PRECISION {

/// A point, and a bound on its distance from the shape.
struct SurfacePoint {
    Vec3 point;
    Real error;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The bound that holds for a point that was projected, if no coordinate that went into it is
/// larger than `largest`.
[[nodiscard]] Real projection_error(Real largest);

// Each returns the point of the shape's surface, its edges apart, that is nearest to the given one,
// which must be near already. Where there is no nearest one, on an axis, it stays.

[[nodiscard]] SurfacePoint projected(const Sphere& sphere, Vec3 point);
[[nodiscard]] SurfacePoint projected(const Plane& plane, Vec3 point);
[[nodiscard]] SurfacePoint projected(const Triangle& triangle, Vec3 point);
[[nodiscard]] SurfacePoint projected(const Square& square, Vec3 point);
[[nodiscard]] SurfacePoint projected(const Cylinder& cylinder, Vec3 point);
[[nodiscard]] SurfacePoint projected(const Cone& cone, Vec3 point);
[[nodiscard]] SurfacePoint projected(const OrientedBox& box, Vec3 point);

}  // namespace rt
