// A picture on a terminal.
#pragma once

#include "common/image.hpp"

#include <string>

namespace rt {

/// The picture in 24-bit colour, two pixels a character, at most `columns` characters wide.
[[nodiscard]] std::string preview(const Image& image, int columns);

}  // namespace rt
