// The picture of the pixels' numbers (--shade), and the legend of its colors.
#pragma once

#include "common/program/options.hpp"
#include "common/render/pixel_values.hpp"

#include <string>
#include <vector>

namespace rt {

/// A picture and its legend.
struct ShadePicture {
    Image image;
    /// First what the numbers are; then for each color "#rrggbb  12 %  4.5", its place on the scale
    /// and its number, or "#rrggbb  sphere 2, 4.5 % of the pixels".
    std::vector<std::string> legend;
};

/// Colors the numbers. The ends of a scale are the smallest and the largest number, if no range is
/// given, and its steps are those of the logarithm. A scale of lengths ends before the farthest
/// twentieth of the pixels, if this is more than twice as far.
[[nodiscard]] ShadePicture shade_picture(const PixelValues& values, const Options& options,
                                         const Scene& scene);

}  // namespace rt
