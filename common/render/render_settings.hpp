// Render settings of the command line: the appearance of the picture, and its cost.
#pragma once

#include "common/image/gamma.hpp"

namespace rt {

/// The conversion of a hit to a color.
enum class Shading {
    color,   ///< as the stage defines it: by a torch at the eye (M1), from stage 9 on by the lights
    normal,  ///< abs(normal)
    // Numbers of the pixel, on a scale of colors (pixel_values.hpp):
    depth,    ///< distance from the eye to the closest hit
    id,       ///< the shape that is hit
    t,        ///< t of the closest hit
    bounces,  ///< the most reflections off mirrors before a ray of the pixel
    samples,  ///< number of rays whose mean the pixel is, with pixel_error
    cost,     ///< number of intersection tests
};

/// Returns whether the shading shows a number of each pixel, and no color.
[[nodiscard]] constexpr bool shows_number(Shading shading) {
    return shading >= Shading::depth;
}

/// The terms of Phong's model to show.
enum class PhongTerm { all, ambient, diffuse, specular };

constexpr int most_pixel_samples = 1 << 20;
constexpr int most_shadow_samples = 1 << 20;
constexpr int most_depth = 1000;

/// Appearance, sampling and recursion limits.
struct RenderSettings {
    Shading shading = Shading::color;
    PhongTerm term = PhongTerm::all;
    Gamma gamma = Gamma::unstated;
    int pixel_samples = 1;    ///< number of rays through each pixel; the largest with pixel_error
    double pixel_error = 0;   ///< trace rays through a pixel until its estimated error is below
                              ///< this, of 255; 0 for always pixel_samples
    int shadow_samples = 16;  ///< largest number of rays to an area light, over √pixel_samples
    double shadow_error =
        0;  ///< stop sampling when the color's estimated error is below this, of 255; 0 for never
    int shadow_agree = 0;  ///< or when the first rays, this many, agree: all reached the light, or
                           ///< none; 0 for never
    int depth = 8;         ///< largest number of successive mirror reflections

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

/// The least number of rays through a pixel with --pixel-error. If fewer agree, they may have
/// missed a corner of the pixel that changes its color by more than the error. From one power of
/// two to the next are four steps, so that a slightly smaller error does not take twice as long.
[[nodiscard]] constexpr int first_pixel_samples(double error) {
    constexpr int fewest = 8;
    constexpr int most = 128;
    int power = fewest;
    while (power < most && 2 * power * error <= 32) power *= 2;
    int count = power;
    while (count < most && count * error < 32) count += power / 4;
    return count;
}

/// The number of rays through a pixel with --pixel-error that follows `count`, if that is not
/// enough: twice as many, because they are best spread at powers of two.
[[nodiscard]] constexpr int next_pixel_samples(int count, int most) {
    return count > most / 2 ? most : 2 * count;
}

}  // namespace rt
