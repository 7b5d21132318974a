// Stage 3: spheres (MRT §3; M1; HAI; CR §2.1–2.2; PHY).
//
//   documents      here
//   o_r, d_r       ray.origin, ray.direction (MRT); o, d (M1, CR); r_0, v (PHY)
//   o, c, r_s      sphere.center (MRT; M1, CR; PHY)
//   r, R           sphere.radius
#pragma once

#include "common/geometry/ray.hpp"
#include "common/geometry/sphere.hpp"

#include <optional>

namespace rt {

/// The smallest t strictly inside the interval at which the ray hits the sphere, from outside or
/// from inside. Returns nothing if there is none, or if a coordinate is NaN. A tangent ray hits the
/// sphere. There is no epsilon: lengths and directions may be of any size in the range of
/// docs/reference/stability.md.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Sphere& sphere,
                                            Interval interval);

/// The outward unit normal at a point of the sphere.
[[nodiscard]] Vec3 normal(const Sphere& sphere, Vec3 point);

/// M1's color of an orientation: |x|, |y|, |z| of the unit normal as red, green, blue. The
/// parameter may have any length.
[[nodiscard]] Color color_from_normal(Vec3 normal);

/// M1's torch at the eye: the cosine of the angle θ between the normal and the direction from the
/// point to the eye, both of any length. Returns 0 where the surface faces away, or if the point is
/// the eye.
[[nodiscard]] Real torch(Vec3 point, Vec3 normal, Vec3 eye);

}  // namespace rt
