// The picture of a scene file, in either precision, and its cost.
#pragma once

#include "common/image/image.hpp"

#include <cstdint>
#include <string>

namespace rt {

struct Drawing {
    std::string refusal;  ///< the reader's, if it refuses the file
    Image image;
    std::int64_t not_a_number = 0;  ///< pixels that are NaN
    double seconds = 0;             ///< processor time, including reading
};

/// Compiled twice, as all that reads scenes.
inline namespace f32 {
[[nodiscard]] Drawing draw(const std::string& file, Resolution size);
}
inline namespace f64 {
[[nodiscard]] Drawing draw(const std::string& file, Resolution size);
}

}  // namespace rt
