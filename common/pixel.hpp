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

}  // namespace rt
