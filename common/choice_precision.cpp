#include "common/choice_precision.hpp"

#include "common/choice_words.hpp"
#include "common/shot_errors.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace rt {

namespace {

/// u of float.
constexpr double float_roundoff = std::numeric_limits<float>::epsilon() / 2;

/// A picture must send so many times the rays of the trials, and so many for each shape that is
/// read again, for float to save more than it costs to try: it is a twentieth quicker.
constexpr double worth_trials = 1000;
constexpr double worth_reading = 400;

/// In float a few pixels on an edge are others. More than one in a thousand is no edge.
constexpr std::size_t edge_pixels = 1000;

/// What a rounding of the precision may do to a color, in 8-bit steps. A point on a shape is off by
/// up to 8 u of its coordinates (docs/stability.md), the normal there by that over the shape's
/// size, and a highlight by so many times that as its exponent says.
double rounding_error(const Demands& demands, double unit_roundoff) {
    if (demands.feature == 0) return 0;
    return 255 * 8 * unit_roundoff * demands.extent / demands.feature * demands.shininess;
}

/// Whether of two surfaces, each off by up to 8 u of its coordinates, either may be in front: as
/// InputRounding::loses_gaps.
bool loses_gaps(const Demands& demands, double unit_roundoff) {
    return demands.gap > 0 && demands.gap < 4 * 8 * unit_roundoff * demands.extent;
}

/// Which pixels float draws otherwise, by more than half of the tolerance.
std::vector<Pixel> other_pixels(TrialRunner& runner, const Trials& trials, const Trials& in_float,
                                const Look& look, const std::vector<Pixel>& pixels) {
    const std::vector<double> apart =
        distances(runner.shot(trials, look, pixels, 0), runner.shot(in_float, look, pixels, 0));
    std::vector<Pixel> others;
    for (std::size_t i = 0; i < apart.size(); ++i)
        if (apart[i] > runner.limit() / 2) others.push_back(pixels[i]);
    return others;
}

/// Whether they are as few, and as far from each other, as those on edges are.
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
        return in_double(", though its roundings may show" + extremes +
                         "; every ray is decided with --precision exact");
    if (rounding_error(demands, float_roundoff) > runner.limit() / 2)
        return in_double(": roundings of float may show" + extremes);
    if (loses_gaps(demands, float_roundoff))
        return in_double(": float may lose a gap of " + number(demands.gap));

    const std::vector<Pixel> pixels = runner.spread().pixels();
    const double rays =
        choice.expected.rays * double(runner.size().width) * double(runner.size().height);
    if (rays < worth_trials * double(pixels.size()) ||
        rays < worth_reading * double(demands.shapes))
        return in_double(": to try float takes more than it could save");
    if (runner.no_time_left()) return in_double(": float might do, but there is no time to try it");

    Trials& in_float = open_float();
    if (choice.hierarchy_from) in_float.arrange(*choice.hierarchy_from);
    const Look look = with_one_shadow_ray(choice.expected.look, runner.aim());
    const std::vector<Pixel> others = other_pixels(runner, trials, in_float, look, pixels);
    const std::string found = std::to_string(others.size()) + " of " +
                              std::to_string(pixels.size()) + " pixels are more than " +
                              steps(runner.limit() / 2) + " off double's";
    if (!are_on_edges(others, pixels.size(), runner.size()))
        return in_double(": in float " + found);
    return {.in_float = true, .why = "float: " + found};
}

}  // namespace rt
