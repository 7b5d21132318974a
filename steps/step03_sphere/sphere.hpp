// Stage 3: spheres (MRT §3; M1; HAI; CR §2.1–2.2; PHY).
//
//   documents      here
//   o_r, d_r       ray.origin, ray.direction (MRT); o, d (M1, CR); r_0, v (PHY)
//   o, c, r_s      sphere.center (MRT; M1, CR; PHY)
//   r, R           sphere.radius
#pragma once

#include "common/ray.hpp"
#include "common/shapes.hpp"

#include <optional>

namespace rt {

/// The smallest t strictly inside the interval at which the ray meets the sphere, from outside
/// or from inside; nothing if there is none, or if a coordinate is NaN. A ray that touches the
/// sphere meets it.
[[nodiscard]] std::optional<Real> intersect(const Ray& ray, const Sphere& sphere,
                                            Interval interval);

/// The unit normal at a point of the sphere, outward.
[[nodiscard]] Vec3 normal(const Sphere& sphere, Vec3 point);

/// M1's colour of an orientation: |x|, |y|, |z| of the unit normal as red, green, blue.
[[nodiscard]] Color color_from_normal(Vec3 normal);

/// M1's torch, held at the eye: cos θ between the normal and the direction from the point to the
/// eye, both of any length; 0 where the surface faces away, or where the point is the eye.
[[nodiscard]] Real torch(Vec3 point, Vec3 normal, Vec3 eye);

}  // namespace rt
