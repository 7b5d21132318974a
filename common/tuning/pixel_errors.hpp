// Error statistics of render settings, estimated from a few pixels.
#pragma once

#include "common/tuning/trial.hpp"

namespace rt {

/// The promise of --tolerance: the largest fraction of the pixels whose error may exceed it.
inline constexpr double few_pixels = 0.01;
/// The same for the pixels in penumbrae, if the number of rays through a pixel is given.
inline constexpr double few_in_penumbrae = 0.1;

/// The color of a pixel of a picture; NaN where it is not a number.
[[nodiscard]] DisplayColor display_color(const Rgb& rgb);

/// The difference of two colors: that of the channel with the largest one, in 8-bit levels.
[[nodiscard]] double distance(const DisplayColor& a, const DisplayColor& b);

/// Returns the largest difference between two neighbors, of which one is at most `reach` columns
/// and rows from the pixel; in 8-bit levels, of the channel with the largest. `reach` is 0 or 1.
[[nodiscard]] int contrast_around(const Image& image, Pixel pixel, int reach);

/// The differences between the pixels of two samples, in 8-bit levels.
[[nodiscard]] std::vector<double> distances(const TrialSample& a, const TrialSample& b);

/// The number of standard errors for 95 % confidence.
inline constexpr double certain_95 = 1.64;

/// The number of trial pixels that may exceed the tolerance, such that with 95 % confidence at most
/// the fraction `share` of all pixels does.
[[nodiscard]] std::size_t allowed_outliers(std::size_t tried, double share);

/// The largest distance after the `allowed_outliers` largest ones are removed; 0 if none remains.
[[nodiscard]] double quantile(std::size_t allowed_outliers, std::vector<double> distances);

/// An upper bound, with 95 % confidence, on the (1 − share) quantile of the distances. With too few
/// pixels to establish it, the bound is larger than all distances.
[[nodiscard]] double error_but_for_share(double share, const std::vector<double>& distances);

/// The chance that a pixel with this error does not keep the tolerance. Two pictures of 8 bits
/// differ by whole levels: colors that differ by 2.3 differ by 3 levels in 3 of 10 cases, and by 2
/// otherwise.
[[nodiscard]] double chance_beyond(double error, double allowed);

/// With 95 % confidence, the largest share of `all` pixels that are beyond if `beyond` of `tried`
/// are (Wilson 1927). The other pixels only are uncertain.
[[nodiscard]] double largest_share(double beyond, double tried, double all);

}  // namespace rt
