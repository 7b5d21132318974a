// Position of a pixel, and size of a picture.
#pragma once

namespace rt {

/// Row from the top and column from the left, both from 0: i and j of MRT §1.
struct Pixel {
    int row = 0;
    int column = 0;
};

/// The size of a picture, in pixels.
struct Resolution {
    int width = 640;
    int height = 480;
};

/// The largest side of a picture, in pixels. A larger one is probably a mistake: 8192 × 8192 pixels
/// already take 1.6 GB of double colors.
inline constexpr int largest_side = 8192;

}  // namespace rt
