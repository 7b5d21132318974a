// Makes a picture or an animation of a scene, or the log or the drawing of one of its pixels.
#pragma once

#include "common/image/pixel.hpp"
#include "common/program/options.hpp"
#include "common/render/render.hpp"
#include "common/render/render_settings.hpp"
#include "common/scene/scene.hpp"
#include "common/tuning/time_budget.hpp"

#include <atomic>
#include <string>

namespace rt {

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
