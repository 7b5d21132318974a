// The log of one pixel (--pixel).
#pragma once

#include "common/image/pixel.hpp"
#include "common/program/options.hpp"
#include "common/scene/scene.hpp"

namespace rt {

/// Prints the log of the pixel's ray, with all quantities from the screen to the color. The pixel
/// is inside the picture.
void explain_pixel(const Program& program, const Options& options, const Scene& scene, Pixel pixel);

}  // namespace rt
