// Directions near the vertical, where axes that are chosen by a threshold are not at right angles.
#pragma once

#include "tests/kit/random.hpp"

#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

/// Up or down, tilted by 0.02° to 5° in any direction; unit length.
inline Vec3 nearly_vertical(Random& random) {
    const Real tilt = pi / 180 * std::pow(Real(10), random.between(Real(-1.7), Real(0.7)));
    const Real azimuth = random.between(-pi, pi);
    const Real up = random.coin() ? 1 : -1;
    const Real across = std::sin(tilt);
    return {across * std::cos(azimuth), up * std::cos(tilt), across * std::sin(azimuth)};
}

/// A basis with a z that is nearly vertical, or vertical, and x and y in any direction around it.
inline Basis nearly_vertical_basis(Random& random) {
    Vec3 z = nearly_vertical(random);
    if (random.below(3) == 0) z = {0, z.y > 0 ? 1 : -1, 0};
    const Real angle = random.between(-pi, pi);
    const Vec3 y = unit(cross(z, Vec3(std::cos(angle), 0, std::sin(angle))));
    return {.x = cross(y, z), .y = y, .z = z};
}

}  // namespace rt
