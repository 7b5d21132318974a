// Reading of PPM files, the simplest pictures.
#pragma once

#include "common/image/image.hpp"

#include <string>

namespace rt {

/// The picture of a PPM file, P6 (bytes) or P3 (decimal numbers), with 255 levels of a color.
/// Throws InputError, located at the file, if it is none, or if its size is not the expected one.
[[nodiscard]] Image read_ppm(const std::string& file, Resolution expected);

}  // namespace rt
