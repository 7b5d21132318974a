// Comparison of the student's picture with the reference.
#pragma once

#include "common/image/image.hpp"

#include <optional>
#include <string>

namespace rt {

/// The differences between two pictures.
struct Comparison {
    Image side_by_side;           ///< the student's, the reference's, and the difference, amplified
    int different = 0;            ///< number of pixels
    int most = 0;                 ///< the largest difference, of 255
    std::optional<Pixel> center;  ///< of the largest cluster of different pixels
};

/// A color near n + ½ may be rounded up or down.
inline constexpr int one_rounding = 1;

/// Compares two pictures. Pixels differ if a color differs by more than `tolerated` levels of 255.
/// Throws InputError if the sizes differ.
[[nodiscard]] Comparison compare(const Image& mine, const Image& reference,
                                 int tolerated = one_rounding);

/// True if two pictures differ, and as two pictures of the same scene do whose random samples
/// differ: in the whole and in each square of 16 x 16 pixels, the differences of either sign
/// balance.
[[nodiscard]] bool is_noise(const Image& mine, const Image& reference);

/// Each pixel as a square of `times` by `times`.
[[nodiscard]] Image magnified(const Image& image, int times);

/// "1234 of 307200 pixels differ, most around row,column 12,34", or a sentence
/// that none differs.
[[nodiscard]] std::string summary(const Comparison& comparison);

}  // namespace rt
