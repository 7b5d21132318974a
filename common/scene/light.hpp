// The lights of a scene, as plain values.
#pragma once

#include "common/math/real.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// Ambient light.
struct Ambient {
    Real ratio = 0;  ///< 0 to 1
    Color color{1};
};

/// A point light or, with a radius, a spherical area light.
struct Light {
    Vec3 position;
    Real brightness = 1;  ///< 0 to 1
    Color color{1};
    Real radius = 0;  ///< radius of the luminous sphere; 0 for a point light
};

}  // namespace RT_PRECISION
}  // namespace rt
