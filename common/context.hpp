// What goes along with the rays of one pixel.
#pragma once

#include "common/look.hpp"
#include "common/pixel.hpp"

#include <cstdint>

namespace rt {

class Story;

struct Context {
    Look look;
    Pixel pixel;
    int bounces = 0;                    ///< off mirrors, since the eye
    double weight = 1;                  ///< of the ray's colour in the pixel's
    Story* story = nullptr;             ///< told everything, if there is one: `--pixel`
    std::int64_t rays = 0;              ///< how many were sent
    std::int64_t sized_light_rays = 0;  ///< of these, to lights with a size
};

}  // namespace rt
