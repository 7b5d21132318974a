// A bounding sphere of a shape.
#pragma once

#include "common/math/real.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// All points at most `radius` from the center.
struct BoundingSphere {
    Vec3 center;
    Real radius = 0;
};

}  // namespace RT_PRECISION
}  // namespace rt
