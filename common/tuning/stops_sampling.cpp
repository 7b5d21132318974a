#include "common/tuning/auto_settings.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/trial_pixels.hpp"

namespace rt {

bool stops_sampling(const Trials& trials, const RenderSettings& settings) {
    constexpr int few = 8;        // that show an error (stage 11)
    constexpr int many = 64;      // a light that is sampled so often counts for all other rays
    constexpr double any = 1e30;  // also in float
    constexpr std::size_t enough = 512;
    RenderSettings to_any_error = with_rays(settings, many);
    to_any_error.shadow_error = any;
    const std::vector<Pixel> pixels = some_of(SpreadPixels(trials.resolution()).pixels(), enough);
    const std::atomic<bool> going_on = false;
    const auto rays = [&](const RenderSettings& tried) {
        return trials.render_pixels(tried, {.pixels = pixels, .threads = 1, .stop = &going_on})
            .rays;
    };
    const double not_stopped = rays(with_rays(settings, many));
    const double least = rays(with_rays(settings, few));
    // The three counts are equal if no pixel sees a light with a size: then nothing needs to stop.
    return rays(to_any_error) <= (least + not_stopped) / 2;
}

}  // namespace rt
