#include "common/tuning/choose_precision.hpp"

#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace rt {

namespace {

/// The unit roundoff of float.
constexpr double float_roundoff = std::numeric_limits<float>::epsilon() / 2;

/// The number of rays of the picture for each ray of the trials, and for each shape that is read
/// again, from which float, a twentieth faster, saves more than its trials cost.
constexpr double worth_trials = 1000;
constexpr double worth_reading = 400;

/// A few pixels on edges differ in float. More than one in a thousand have another cause.
constexpr std::size_t edge_pixels = 1000;

/// An upper bound on the effect of rounding errors on a color, in 8-bit levels. A point on a shape
/// has an error of up to 8 u of its coordinates (docs/reference/stability.md); the normal there has
/// that error divided by the shape's size, and a highlight that of the normal times its exponent.
double rounding_error(const Demands& demands, double unit_roundoff) {
    if (demands.feature == 0) return 0;
    return 255 * 8 * unit_roundoff * demands.extent / demands.feature * demands.shininess;
}

/// Returns whether rounding errors, up to 8 u of the coordinates of each surface, may exchange the
/// order of two surfaces: as InputRounding::loses_gaps.
bool loses_gaps(const Demands& demands, double unit_roundoff) {
    return demands.gap > 0 && demands.gap < 4 * 8 * unit_roundoff * demands.extent;
}

/// The pixels whose color differs in float by more than half of the tolerance.
std::vector<Pixel> other_pixels(TrialRunner& runner, const Trials& trials, const Trials& in_float,
                                const Look& look, const std::vector<Pixel>& pixels) {
    const std::vector<double> apart =
        distances(runner.shot(trials, look, pixels, 0), runner.shot(in_float, look, pixels, 0));
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

PrecisionChoice choose_precision(TrialRunner& runner, const Trials& trials, const Demands& demands,
                                 const OpenFloat& open_float, const Choice& choice) {
    const auto in_double = [](const std::string& why) {
        return PrecisionChoice{.why = "double" + why};
    };
    if (!open_float) return {.why = "as given"};
    const std::string extremes = ": coordinates reach " + number(demands.extent) +
                                 ", the smallest size is " + number(demands.feature);
    if (rounding_error(demands, demands.unit_roundoff) > runner.limit() / 2)
        return in_double(", though its rounding errors may be visible" + extremes +
                         "; every ray is decided with --precision exact");
    if (rounding_error(demands, float_roundoff) > runner.limit() / 2)
        return in_double(": rounding errors of float may be visible" + extremes);
    if (loses_gaps(demands, float_roundoff))
        return in_double(": float may lose a gap of " + number(demands.gap));

    const std::vector<Pixel> pixels = runner.spread().pixels();
    const double rays =
        choice.expected.rays * double(runner.size().width) * double(runner.size().height);
    if (rays < worth_trials * double(pixels.size()) ||
        rays < worth_reading * double(demands.shapes))
        return in_double(": trying float costs more than it could save");
    if (runner.no_time_left())
        return in_double(": float may be sufficient, but there is no time to try it");

    Trials& in_float = open_float();
    if (choice.hierarchy_from) in_float.arrange(*choice.hierarchy_from);
    const Look look = with_one_shadow_ray(choice.expected.look, runner.aim());
    const std::vector<Pixel> others = other_pixels(runner, trials, in_float, look, pixels);
    const std::string found =
        std::to_string(others.size()) + " of " + std::to_string(pixels.size()) +
        " pixels differ from double's by more than " + steps(runner.limit() / 2);
    if (!are_on_edges(others, pixels.size(), runner.size()))
        return in_double(": in float " + found);
    return {.in_float = true, .why = "float: " + found};
}

}  // namespace rt
