// My picture beside the reference's.
#pragma once

#include "common/image.hpp"

#include <optional>
#include <string>

namespace rt {

/// Where two pictures differ, and by how much.
struct Comparison {
    Image side_by_side;           ///< mine, the reference's, and the difference, amplified
    int different = 0;            ///< pixels
    int most = 0;                 ///< the largest difference, of 255
    std::optional<Pixel> center;  ///< of the largest cluster of them
};

/// Compares two pictures. Throws InputError if they are not of one size.
[[nodiscard]] Comparison compare(const Image& mine, const Image& reference);

/// "1,234 of 307,200 pixels differ, by 255 at most; …", or that none does.
[[nodiscard]] std::string summary(const Comparison& comparison);

}  // namespace rt
