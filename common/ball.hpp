// A bounding sphere of a shape.
#pragma once

#include "common/real.hpp"

namespace rt::inline RT_PRECISION {

struct Ball {
    Vec3 center;
    Real radius = 0;
};

}  // namespace rt::inline RT_PRECISION
