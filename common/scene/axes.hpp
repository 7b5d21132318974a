// Coordinate axes of a scene, and their conversion to the program's: x right, y up, z toward the
// viewer.
#pragma once

#include "common/math/real.hpp"

namespace rt {

/// The axes that a scene file uses. A scene from a program with other conventions is rotated or
/// mirrored as a whole when it is read.
struct Axes {
    bool left_handed = false;  ///< left-handed: left and right are exchanged in the picture
    bool z_up = false;         ///< z points up and y away from the viewer
};

inline namespace RT_PRECISION {

/// Converts a point or a direction of the scene to the program's axes. Exact: components only
/// change place and sign.
[[nodiscard]] inline Vec3 to_our_axes(Vec3 v, Axes axes) {
    if (axes.z_up) v = Vec3(v.x, v.z, 0 - v.y);
    if (axes.left_handed) v.x = 0 - v.x;
    return v;
}

/// The inverse of to_our_axes, exact as well.
[[nodiscard]] inline Vec3 to_its_axes(Vec3 v, Axes axes) {
    if (axes.left_handed) v.x = 0 - v.x;
    if (axes.z_up) v = Vec3(v.x, 0 - v.z, v.y);
    return v;
}

}  // namespace RT_PRECISION
}  // namespace rt
