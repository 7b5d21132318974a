// Colors for numbers: a scale from dark violet by blue and green to light yellow, and distinct
// colors for things that have no order.
#pragma once

#include "common/image/image.hpp"

#include <string>

namespace rt {

/// The color at a share, 0 to 1, of the scale; outside, that of the nearer end. Equal steps of the
/// share are equal steps of perceived lightness (Ottosson 2020, "A perceptual color space for image
/// processing"), so that the scale has an order also in gray, or for an eye that sees fewer hues.
[[nodiscard]] Rgb scale_color(double share);

/// A color for the number, from 0 on, of something without an order. Near numbers have very
/// different hues.
[[nodiscard]] Rgb distinct_color(int number);

/// "#rrggbb"
[[nodiscard]] std::string hex(Rgb color);

}  // namespace rt
