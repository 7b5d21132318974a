#include "common/tuning/candidates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {

std::vector<Look> sampling_looks(Look look) {
    std::vector<Look> all;
    for (const int samples : {1, 2, 4}) all.push_back(with_rays(look, samples));
    for (double steps = 16; steps > 1.0 / 33; steps /= std::sqrt(2))
        all.push_back(to_error(look, steps, 0));
    return all;
}

Look with_rays(Look look, int rays) {
    look.shadow_samples = rays;
    look.shadow_error = 0;
    look.shadow_agree = 0;
    return look;
}

Look to_error(Look look, double error, int agree) {
    look.shadow_samples = most_shadow_samples;
    look.shadow_error = error;
    look.shadow_agree = agree;
    return look;
}

Look reference_look(Look look, double tolerance) {
    // If this many rays agree, the part of the light that they may have missed is about half of 1 /
    // agree: less than the tolerance.
    const auto agree = unsigned(std::clamp(200 / tolerance, 32., double(most_shadow_samples)));
    return to_error(look, tolerance / 2, int(std::bit_floor(agree)));
}

double excess(const Look& look, const Look& finer) {
    const double fewer = double(look.shadow_samples) / finer.shadow_samples;
    return std::hypot(
        1, look.shadow_error > 0 ? finer.shadow_error / look.shadow_error : std::pow(fewer, 0.75));
}

}  // namespace rt
