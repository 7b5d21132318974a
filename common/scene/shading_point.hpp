// The shading point: the geometry and the material that shading a hit requires.
#pragma once

#include "common/math/real.hpp"
#include "common/scene/material.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// A point on a surface as seen by an eye: lengths in units of the scene.
struct ShadingPoint {
    Vec3 point;
    Vec3 normal;            ///< unit length, on the side of the eye
    Vec3 geometric_normal;  ///< geometric normal: as normal, but never interpolated
    Vec3 to_eye;            ///< unit length
    Real error = 0;         ///< upper bound on the distance from the point to the shape
    Material material;
};

}  // namespace RT_PRECISION
}  // namespace rt
