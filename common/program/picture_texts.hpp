// The texts that a picture's file contains beside the pixels.
#pragma once

#include "common/image/png.hpp"
#include "common/program/options.hpp"

#include <string>
#include <vector>

namespace rt {

/// "640 x 480"
[[nodiscard]] std::string size_text(Resolution size);

/// Returns everything that determined the picture. The number of threads does not affect it.
[[nodiscard]] std::vector<PngText> picture_texts(const Program& program, const Options& options,
                                                 Resolution size);

}  // namespace rt
