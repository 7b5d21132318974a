#include "common/tuning/candidates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {

std::vector<RenderSettings> sampling_candidates(RenderSettings settings) {
    std::vector<RenderSettings> all;
    for (const int samples : {1, 2, 4}) all.push_back(with_rays(settings, samples));
    for (double steps = 16; steps > 1.0 / 33; steps /= std::sqrt(2))
        all.push_back(to_error(settings, steps, 0));
    return all;
}

RenderSettings with_rays(RenderSettings settings, int rays) {
    settings.shadow_samples = rays;
    settings.shadow_error = 0;
    settings.shadow_agree = 0;
    return settings;
}

RenderSettings to_error(RenderSettings settings, double error, int agree) {
    settings.shadow_samples = most_shadow_samples;
    settings.shadow_error = error;
    settings.shadow_agree = agree;
    return settings;
}

RenderSettings reference_settings(RenderSettings settings, double tolerance) {
    // If this many rays agree, the part of the light that they may have missed is about half of 1 /
    // agree: less than the tolerance.
    const auto agree = unsigned(std::clamp(200 / tolerance, 32., double(most_shadow_samples)));
    return to_error(settings, tolerance / 2, int(std::bit_floor(agree)));
}

double reference_bias(const RenderSettings& settings, const RenderSettings& finer) {
    const double fewer = double(settings.shadow_samples) / finer.shadow_samples;
    return std::hypot(1, settings.shadow_error > 0 ? finer.shadow_error / settings.shadow_error
                                                   : std::pow(fewer, 0.75));
}

}  // namespace rt
