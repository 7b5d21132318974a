#include "common/image/image.hpp"

#include <stdexcept>
#include <string>

namespace rt {

void throw_outside(Pixel pixel, Resolution resolution) {
    throw std::out_of_range(
        "row " + std::to_string(pixel.row) + ", column " + std::to_string(pixel.column) +
        " is outside of an image of " + std::to_string(resolution.width) + " x " +
        std::to_string(resolution.height) + " pixels, whose rows and columns count from 0");
}

}  // namespace rt
