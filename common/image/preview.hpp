// A picture in a terminal.
#pragma once

#include "common/image/image.hpp"

#include <string>

namespace rt {

/// Returns the picture as text with 24-bit color codes: two pixels for each character, at most
/// `columns` characters wide.
[[nodiscard]] std::string preview(const Image& image, int columns);

}  // namespace rt
