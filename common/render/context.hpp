// State that accompanies the rays of one pixel.
#pragma once

#include "common/image/pixel.hpp"
#include "common/render/render_settings.hpp"

#include <cstdint>

namespace rt {

class PixelLog;
struct RayRecords;

/// The receiver of events from closest-hit and any-hit queries.
struct Watch {
    PixelLog* log = nullptr;        ///< of `--pixel`, or null
    RayRecords* records = nullptr;  ///< or null
};

/// The settings, the state and the counters of the rays of one pixel.
struct Context {
    RenderSettings settings;
    Pixel pixel;        ///< its random numbers are its own; of a finer picture for a sample
    Pixel whole_pixel;  ///< for a sample: the picture's pixel
    int sample = -1;    ///< index among the rays through the pixel (pixel_samples.hpp), or −1
    int bounces = 0;    ///< reflections off mirrors since the camera
    double weight = 1;  ///< weight of the ray's color in the pixel's color
    PixelLog* log = nullptr;            ///< the log of `--pixel`, or null
    const Watch* watch = nullptr;       ///< with the same log; null for most pictures
    std::int64_t rays = 0;              ///< number of rays traced
    std::int64_t sized_light_rays = 0;  ///< of these, rays to area lights
};

}  // namespace rt
