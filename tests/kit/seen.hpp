// The color that a stage's `trace` gives to one pixel of a small scene.
#pragma once

#include "tests/kit/verdict.hpp"

#include "common/image/image.hpp"
#include "common/render/render_settings.hpp"

#include <string>

namespace rt {

/// The color, of 255, of a picture of one pixel. The scene is in the form of docs/scenes.md. Its
/// camera is at the origin and looks along 0,0,-1, unless it has one of its own; the ray of the
/// pixel has that direction.
[[nodiscard]] Rgb seen(const std::string& scene, const RenderSettings& settings = {});

/// The same color before it is rounded and clamped: 1 is 255.
[[nodiscard]] Color seen_unrounded(const std::string& scene, const RenderSettings& settings = {});

/// A color as in a scene's text: "255,0,0".
[[nodiscard]] std::string scene_color(Rgb color);

/// The first lines of a sentence about a picture of one pixel: what is tested, and the scene, with
/// the options of the command line that render it with these settings.
[[nodiscard]] std::string pixel_report(const std::string& what, const std::string& scene,
                                       const RenderSettings& settings = {});

/// The pixel has the expected color, to 1 of 255 or the given difference. The sentence contains the
/// scene, which a student can save and render, unless it is long.
[[nodiscard]] Verdict shows(const std::string& scene, Rgb expected,
                            const RenderSettings& settings = {}, int difference = 1);

/// The color of each pixel of a picture of the same scene. The rays share a Context, as those of a
/// row of a picture.
[[nodiscard]] Image picture_seen(const std::string& scene, Resolution resolution,
                                 const RenderSettings& settings = {});

/// Every pixel of a small picture, of which each ray has another direction, has the color.
[[nodiscard]] Verdict shows_in_every_pixel(const std::string& scene, Rgb expected,
                                           const RenderSettings& settings = {});

}  // namespace rt
