// The choice of the number of rays through a pixel, together with that of shadow rays.
#pragma once

#include "common/tuning/pixel_study.hpp"
#include "common/tuning/tradeoff.hpp"
#include "common/tuning/trial_runner.hpp"

#include <string>

namespace rt {

/// Returns the settings with the rays to lights that are chosen with those through pixels. The only
/// ray through a pixel sends 8, 16 or 32 to each light: more if more of the pixels that a shape may
/// shade are in a penumbra, and at most 16 in a scene of many shapes. Each of several rays sends a
/// quarter of that. Where a shaft (shaft.hpp) leaves few shapes in the way, they take hardly longer
/// than one, and save rays through pixels. None stops early: rays that stop once a few agree would
/// make the mean of a pixel wrong, however many go through it. If the rays through the centers then
/// took more than a quarter of the time given, it is 4 to each light.
[[nodiscard]] RenderSettings with_few_shadow_rays(TrialRunner& runner, const Trials& trials,
                                                  const SceneTraits& traits,
                                                  const RenderSettings& settings);

/// Returns the settings that keep the tolerance with few rays, or the most accurate ones found:
/// one ray through each pixel, or more beside edges, or, where such edges are not all, more through
/// every pixel. The result is the same in every run, because no clock decides.
[[nodiscard]] Trial keep_tolerance_of_pixels(PixelStudy& study);

/// Measures settings for a time budget, cheapest first: with more rays beside edges, or, if
/// there is time for many, through every pixel. The settings of a ladder differ in thresholds only,
/// or in the number of rays only, so that each row of a picture can have its own.
[[nodiscard]] QualityLadder measure_pixel_ladder(const TrialRunner& runner, PixelStudy& study);

/// Describes the rays through a pixel, for example "16".
[[nodiscard]] std::string pixels_in_words(const RenderSettings& settings);

}  // namespace rt
