// The sky of a scene: what a ray sees that hits nothing.
#pragma once

#include "common/math/real.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// A gradient of two colors by the direction of the ray.
struct Sky {
    Color bottom;  ///< straight down
    Color top;     ///< straight up
};

}  // namespace RT_PRECISION
}  // namespace rt
