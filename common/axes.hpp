// The axes of a scene's coordinates, and their change to ours: x right, y up, z to the viewer.
#pragma once

#include "common/real.hpp"

namespace rt {

/// Many programs have other axes than ours. A scene of theirs is turned, or mirrored, as a whole
/// when it is read.
struct Axes {
    bool left_handed = false;  ///< left and right are exchanged in the picture
    bool z_up = false;         ///< z points upwards, and y away from the viewer
};

}  // namespace rt

namespace rt::inline RT_PRECISION {

/// A point or a direction of the scene in our axes: exact, as components change places and signs.
[[nodiscard]] inline Vec3 to_our_axes(Vec3 v, Axes axes) {
    if (axes.z_up) v = Vec3(v.x, v.z, 0 - v.y);
    if (axes.left_handed) v.x = 0 - v.x;
    return v;
}

/// The other way.
[[nodiscard]] inline Vec3 to_its_axes(Vec3 v, Axes axes) {
    if (axes.left_handed) v.x = 0 - v.x;
    if (axes.z_up) v = Vec3(v.x, 0 - v.z, v.y);
    return v;
}

}  // namespace rt::inline RT_PRECISION
