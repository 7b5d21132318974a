// An orthonormal basis: three unit axes at right angles.
#pragma once

#include "common/math/real.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// An orthonormal basis. It is right-handed, x × y = z, except in a Transform that reflects.
struct Basis {
    Vec3 x{1, 0, 0};
    Vec3 y{0, 1, 0};
    Vec3 z{0, 0, 1};

    bool operator==(const Basis&) const = default;
};

/// The type of stage 2's orthonormal_basis: returns a basis whose z axis points along `z`.
using BasisAround = Basis(Vec3 z);

}  // namespace RT_PRECISION
}  // namespace rt
