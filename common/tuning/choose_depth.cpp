#include "common/tuning/choose_depth.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

int sufficient_depth(double strongest_mirror, double tolerance) {
    // The omitted reflections use at most an eighth of the tolerance; the samples use the rest.
    const double visible = tolerance / 8 / 255;
    if (strongest_mirror <= 0 || visible >= 1) return 0;
    if (strongest_mirror >= 1) return most_depth;
    const double reflections = std::log(visible) / std::log(strongest_mirror);
    return int(std::clamp(std::ceil(reflections) - 1, 0., double(most_depth)));
}

int depth_within_time(TrialRunner& runner, const Trials& trials, const RenderSettings& given) {
    const CheaperPicture cheaper = with_few_rays(given);
    RenderSettings settings = cheaper.settings;
    const std::vector<Pixel> all = runner.spread().pixels();
    const std::vector<Pixel> pixels = some_of(all, std::max<std::size_t>(all.size() / 8, 512));
    const auto takes_too_long = [&] {
        const double seconds = runner.render_pixels(trials, settings, pixels, 0).seconds;
        return runner.picture_seconds(cheaper.times * seconds) > *runner.aim().time;
    };
    while (settings.depth > 0 && takes_too_long()) settings.depth /= 2;
    return settings.depth;
}

}  // namespace rt
