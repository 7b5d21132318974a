#include "common/tuning/choices.hpp"

#include "common/tuning/pixel_errors.hpp"

#include <algorithm>

namespace rt {

SeenDepth seen_depth(TrialRunner& runner, const Trials& trials, const RenderSettings& deepest) {
    constexpr std::size_t enough = 512;  // less than 0.6 % of the pixels need more, probably
    const std::vector<Pixel> pixels = some_of(runner.spread().pixels(), enough);
    RenderSettings settings = with_few_rays(deepest).settings;
    const TrialSample right = runner.render_pixels(trials, settings, pixels, 0);
    for (settings.depth = 1; settings.depth < deepest.depth;
         settings.depth += 1 + settings.depth / 4) {
        const std::vector<double> off =
            distances(runner.render_pixels(trials, settings, pixels, 0), right);
        if (*std::ranges::max_element(off) <= runner.limit() / 8) break;
    }
    return {std::min(settings.depth, deepest.depth), pixels.size()};
}

int depth_within_time(TrialRunner& runner, const Trials& trials, const RenderSettings& given) {
    constexpr int few = 8;  // a trial with all reflections could take longer than the picture may
    const CheaperPicture cheaper = with_few_rays(given);
    const double allowed = *runner.aim().time / 2;
    const std::vector<Pixel> all = runner.spread().pixels();
    const std::vector<Pixel> pixels =
        some_of(all, std::clamp<std::size_t>(all.size() / 4, 64, 512));
    const auto seconds_with = [&](int depth) {
        RenderSettings settings = cheaper.settings;
        settings.depth = depth;
        const double seconds = runner.render_pixels(trials, settings, pixels, 0).seconds;
        return runner.picture_seconds(cheaper.times * seconds);
    };
    int depth = std::min(given.depth, few);
    double seconds = seconds_with(depth);
    while (depth > 0 && seconds > allowed) seconds = seconds_with(depth /= 2);
    // With n times the depth, the picture takes up to n times as long.
    while (0 < depth && depth < given.depth && 2 * seconds <= allowed) {
        const double deeper = double(depth) * allowed / std::max(seconds, 1e-9);
        const int next = int(std::min(deeper, double(given.depth)));
        seconds = seconds_with(next);
        if (seconds > allowed) break;
        depth = next;
    }
    return depth;
}

}  // namespace rt
