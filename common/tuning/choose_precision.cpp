#include "common/tuning/choices.hpp"

#include "common/system/input_error.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <map>

namespace rt {

namespace {

/// The part of the time of paths that float saves, and of rays to lights, decided many at once.
constexpr double saved_part = 0.06;
constexpr double saved_part_of_soft = 0.15;

/// The paths of a typical picture through each pixel, and the rays to a light with a size.
constexpr double typical_paths = 16;
constexpr double typical_light_rays = 64;

/// The rays that float must save for each trial pixel, and for each shape that is read again.
constexpr double worth_trials = 8;
constexpr double worth_reading = 20;

/// A few pixels on edges differ in float. More than one in a thousand have another cause.
constexpr std::size_t edge_pixels = 1000;

/// An upper bound on the effect of rounding errors on a color, in 8-bit levels. A point on a shape
/// is displaced by rounding; the normal there has that error divided by the shape's size, and a
/// highlight that of the normal times its exponent.
double rounding_error(const SceneTraits& traits, double unit_roundoff) {
    const SceneLengths& lengths = traits.lengths;
    if (lengths.smallest == 0) return 0;
    return 255 * lengths.displacement(unit_roundoff) / lengths.smallest * traits.shininess;
}

/// The pixels whose color differs in float by more than half of the tolerance.
std::vector<Pixel> other_pixels(TrialRunner& runner, const Trials& trials, const Trials& in_float,
                                const RenderSettings& settings, const std::vector<Pixel>& pixels) {
    const std::vector<double> apart =
        distances(runner.render_pixels(trials, settings, pixels, 0),
                  runner.render_pixels(in_float, settings, pixels, 0));
    std::vector<Pixel> others;
    for (std::size_t i = 0; i < apart.size(); ++i)
        if (apart[i] > runner.limit() / 2) others.push_back(pixels[i]);
    return others;
}

/// Returns whether the pixels are as few, and as far apart, as pixels on edges.
bool are_on_edges(const std::vector<Pixel>& others, std::size_t tried, Resolution size) {
    if (others.size() * edge_pixels > tried) return false;
    std::map<int, int> in_tile;
    return std::ranges::none_of(others,
                                [&](Pixel pixel) { return ++in_tile[tile_of(pixel, size)] > 1; });
}

}  // namespace

PrecisionChoice choose_precision(TrialRunner& runner, const Trials& trials,
                                 const SceneTraits& traits, const OpenFloat& open_float,
                                 const RenderSettings& settings) {
    const auto in_double = [](const std::string& why) {
        return PrecisionChoice{.why = "double" + why};
    };
    if (!open_float) return {.why = "as given"};
    const std::string extremes = ": coordinates reach " + number(traits.lengths.largest) +
                                 ", the smallest size is " + number(traits.lengths.smallest);
    if (rounding_error(traits, traits.unit_roundoff) > runner.limit() / 2)
        return in_double(", though its rounding errors may be visible" + extremes +
                         "; every ray is decided with --precision exact");
    if (rounding_error(traits, float_unit_roundoff) > runner.limit() / 2)
        return in_double(": rounding errors of float may be visible" + extremes);

    const std::vector<Pixel> pixels = runner.spread().pixels();
    const double paths = runner.aim().given.pixel_samples ? settings.pixel_samples : typical_paths;
    const double saved =
        saved_part * paths + (traits.sized_lights ? saved_part_of_soft * typical_light_rays : 0);
    const double rays = saved * runner.pixels();
    if (rays < worth_trials * double(pixels.size()) || rays < worth_reading * double(traits.shapes))
        return in_double(": trying float costs more than it could save");
    if (runner.no_time_left())
        return in_double(": float may be sufficient, but there is no time to try it");
    SceneLengths lengths = traits.lengths;
    lengths.gap = trials.smallest_gap();
    if (lengths.loses_gaps(float_unit_roundoff))
        return in_double(": float may lose a gap of " + number(lengths.gap));

    Trials* opened = nullptr;
    try {
        opened = &open_float();
    } catch (const InputError&) {  // double has read the same files
        return in_double(": float cannot represent a number of the scene");
    }
    Trials& in_float = *opened;
    const std::vector<Pixel> others =
        other_pixels(runner, trials, in_float,
                     with_few_rays(with_one_shadow_ray(settings, runner.aim())).settings, pixels);
    const std::string found =
        std::to_string(others.size()) + " of " + std::to_string(pixels.size()) +
        " pixels differ from double's by more than " + levels(runner.limit() / 2);
    if (!are_on_edges(others, pixels.size(), runner.size()))
        return in_double(": in float " + found);
    return {.in_float = &in_float, .why = "float: " + found};
}

}  // namespace rt
