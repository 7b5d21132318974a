// The shapes of a scene, as plain values: the parameters of the file, without cached quantities.
#pragma once

#include "common/math/basis.hpp"

namespace rt {
inline namespace RT_PRECISION {

struct Sphere {
    Vec3 center;
    Real radius = 1;  ///< positive

    bool operator==(const Sphere&) const = default;
};

/// The points p with ⟨p − point, normal⟩ = 0.
struct Plane {
    Vec3 point;
    Vec3 normal{0, 1, 0};  ///< any non-zero length
};

/// A triangle including its edges and vertices. The normal (b − a) × (c − a) points to the side
/// from which a, b, c are counterclockwise.
struct Triangle {
    Vec3 a;
    Vec3 b;
    Vec3 c;

    bool operator==(const Triangle&) const = default;
};

/// |x| ≤ side / 2 and |y| ≤ side / 2 in object space (MRT §6). It rotates with its basis.
struct Square {
    Vec3 center;
    Basis basis;  ///< x and y along the sides, z is the normal
    Real side = 1;
    bool one_sided = false;  ///< visible only from the side of its normal (HAI)

    bool operator==(const Square&) const = default;
};

/// The lateral surface of a cylinder without caps: distance `radius` from the axis,
/// |z| ≤ height / 2 (MRT §7).
struct Cylinder {
    Vec3 center;         ///< midpoint of the axis
    Vec3 axis{0, 1, 0};  ///< unit length
    Real radius = 1;
    Real height = 1;

    bool operator==(const Cylinder&) const = default;
};

/// The lateral surface of one nappe of a cone without base: x² + y² = (radius / height)² z²,
/// 0 ≤ z ≤ height (MRT §8, with its coefficient corrected). The cone opens along the axis.
struct Cone {
    Vec3 apex;
    Vec3 axis{0, 1, 0};  ///< unit length, from the apex into the cone
    Real radius = 1;     ///< radius at distance `height` from the apex
    Real height = 1;

    bool operator==(const Cone&) const = default;
};

/// |x|, |y| and |z| ≤ the components of half_size in object space (M1, "boite orientée").
struct OrientedBox {
    Vec3 center;
    Basis basis;
    Vec3 half_size{Real(0.5)};  ///< along x, y and z of the basis

    bool operator==(const OrientedBox&) const = default;
};

}  // namespace RT_PRECISION
}  // namespace rt
