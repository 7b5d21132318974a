// The contrast of a picture around a pixel.
#pragma once

#include "common/image/image.hpp"

namespace rt {

/// Returns the largest difference between two neighbors, of which one is at most `reach` columns
/// and rows from the pixel; in 8-bit levels, of the channel with the largest. `reach` is 0 or 1.
[[nodiscard]] int contrast_around(const Image& image, Pixel pixel, int reach);

}  // namespace rt
