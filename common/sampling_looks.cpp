#include "common/sampling_looks.hpp"

#include <cmath>

namespace rt {

std::vector<Look> sampling_looks(Look look) {
    std::vector<Look> all;
    look.shadow_error = 0;
    for (const int samples : {1, 2, 4}) {
        look.shadow_samples = samples;
        all.push_back(look);
    }
    look.shadow_samples = most_shadow_samples;
    for (double steps = 16; steps > 1.0 / 33; steps /= std::sqrt(2)) {
        look.shadow_error = steps;
        all.push_back(look);
    }
    return all;
}

Look finer_than(Look look) {
    if (look.shadow_error > 0)
        look.shadow_error /= std::sqrt(2);
    else
        look.shadow_samples *= 8;
    return look;
}

double excess(const Look& look, const Look& finer) {
    const double fewer = double(look.shadow_samples) / finer.shadow_samples;
    return std::hypot(
        1, look.shadow_error > 0 ? finer.shadow_error / look.shadow_error : std::pow(fewer, 0.75));
}

std::vector<Look> looks_around(Look look) {
    std::vector<Look> all;
    if (look.shadow_error > 0) {
        look.shadow_error *= better_sampled;
        for (const int agree : {8, 16, 32, 64, 128, 0}) {
            look.shadow_agree = agree;
            all.push_back(look);
        }
    } else {
        for (const double times : {1., 1.5, 2.}) {
            all.push_back(look);
            all.back().shadow_samples = int(times * look.shadow_samples + 0.5);
        }
        look.shadow_samples = most_shadow_samples;
        look.shadow_agree = 8;
        for (const int steps : {16, 8, 4}) {
            look.shadow_error = steps;
            all.push_back(look);
        }
    }
    return all;
}

Look fewer_agree(Look look) {
    constexpr int first = 80;
    look.shadow_agree = look.shadow_agree > 0 ? look.shadow_agree * 5 / 8 : first;
    look.shadow_error *= better_sampled;
    return look;
}

}  // namespace rt
