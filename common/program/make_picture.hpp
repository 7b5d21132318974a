// Makes a picture or an animation of a scene, or the log or the drawing of one of its pixels.
#pragma once

#include "common/image/image.hpp"
#include "common/image/pixel.hpp"
#include "common/program/options.hpp"
#include "common/render/pixel_values.hpp"
#include "common/render/render.hpp"
#include "common/render/render_settings.hpp"
#include "common/scene/scene.hpp"
#include "common/tuning/time_budget.hpp"

#include <atomic>
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

/// Returns one sentence if all pixels of the stage's picture have one color, else an empty string.
/// The remedy that it suggests has been tried with a few rays. The picture is that of the scene's
/// first camera. Empty too if a function that is not written yet was called: that is the reason.
[[nodiscard]] std::string why_blank(const Scene& scene, const RenderSettings& settings, int stage,
                                    const Image& image);

/// The result of render_centers, and the seconds by the clock that it took.
struct TracedCenters {
    Rendering rendering;
    double seconds = 0;
};

/// Renders the scene, writes the picture with its legend, and reports the result, with the seconds
/// by the clock of both. `centers`, if not null, is that of the same settings, and is moved from. A
/// time budget `pace`, if not null, changes the settings from row to row. Returns false, and leaves
/// no file, if it was stopped.
[[nodiscard]] bool make_picture(const Program& program, const Options& options, const Scene& scene,
                                TracedCenters* centers, TimeBudget* pace,
                                const std::atomic<bool>& stop);

/// Renders the frames of `--turn` to an animated PNG, and reports the result. Returns false, and
/// leaves no file, if it was stopped. Throws InputError if the scene has nothing to go around.
[[nodiscard]] bool make_animation(const Program& program, const Options& options,
                                  const Scene& scene, const std::atomic<bool>& stop);

/// Prints the log of the pixel's ray, with all quantities from the screen to the color. The pixel
/// is inside the picture.
void explain_pixel(const Program& program, const Options& options, const Scene& scene, Pixel pixel);

/// Returns the drawing as one line of JSON, for the page of `./course view`. Numbers in texts are
/// those of `--pixel`.
[[nodiscard]] std::string ray_drawing(const Scene& scene, const RenderSettings& settings,
                                      Pixel pixel);

}  // namespace rt
