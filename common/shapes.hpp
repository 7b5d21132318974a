// The shapes of a scene, as plain values: what the file says, and nothing cached.
#pragma once

#include "common/basis.hpp"

namespace rt::inline RT_PRECISION {

struct Sphere {
    Vec3 center;
    Real radius = 1;  ///< positive

    bool operator==(const Sphere&) const = default;
};

/// All points p with ⟨p − point, normal⟩ = 0.
struct Plane {
    Vec3 point;
    Vec3 normal{0, 1, 0};  ///< any non-zero length
};

/// Its edges and vertices belong to it. The normal (b − a) × (c − a) points to whoever sees
/// a, b, c turn anticlockwise.
struct Triangle {
    Vec3 a;
    Vec3 b;
    Vec3 c;

    bool operator==(const Triangle&) const = default;
};

/// |x| ≤ side / 2 and |y| ≤ side / 2 in its own frame (MRT §6). It turns as its basis turns.
struct Square {
    Vec3 center;
    Basis basis;  ///< x and y along its sides, z its normal
    Real side = 1;
    bool one_sided = false;  ///< seen only from the side its normal points to (HAI)

    bool operator==(const Square&) const = default;
};

/// The side of a tube, without caps: distance radius from the axis, |z| ≤ height / 2 (MRT §7).
struct Cylinder {
    Vec3 center;         ///< half-way along the axis
    Vec3 axis{0, 1, 0};  ///< unit length
    Real radius = 1;
    Real height = 1;

    bool operator==(const Cylinder&) const = default;
};

/// The side of one nappe, without base: x² + y² = (radius / height)² z², 0 ≤ z ≤ height
/// (MRT §8, its coefficient put right). It opens along the axis.
struct Cone {
    Vec3 apex;
    Vec3 axis{0, 1, 0};  ///< unit length, from the apex into the cone
    Real radius = 1;     ///< at height
    Real height = 1;

    bool operator==(const Cone&) const = default;
};

/// |x|, |y| and |z| ≤ half_size's in its own frame (M1, "boite orientée").
struct OrientedBox {
    Vec3 center;
    Basis basis;
    Vec3 half_size{Real(0.5)};  ///< along the basis's x, y and z

    bool operator==(const OrientedBox&) const = default;
};

}  // namespace rt::inline RT_PRECISION
