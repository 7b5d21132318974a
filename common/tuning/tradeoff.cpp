#include "common/tuning/tradeoff.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rt {

namespace {

/// The least time of a trial: a clock's resolution may be too low to measure it.
constexpr double least = 1e-9;

Trial between(const Trial& cheap, const Trial& good, double share) {
    const auto mean = [share](double a, double b) {
        constexpr double tiny = 1e-9;
        return std::pow(std::max(a, tiny), 1 - share) * std::pow(std::max(b, tiny), share);
    };
    Trial trial = good;
    if (cheap.settings.shadow_error > 0 && good.settings.shadow_error > 0)
        trial.settings.shadow_error = mean(cheap.settings.shadow_error, good.settings.shadow_error);
    if (cheap.settings.pixel_error > 0 && good.settings.pixel_error > 0)
        trial.settings.pixel_error = mean(cheap.settings.pixel_error, good.settings.pixel_error);
    trial.settings.pixel_samples =
        int(std::lround(mean(cheap.settings.pixel_samples, good.settings.pixel_samples)));
    if (cheap.settings.shadow_agree > 0 && good.settings.shadow_agree > 0)
        trial.settings.shadow_agree =
            int(std::lround(mean(cheap.settings.shadow_agree, good.settings.shadow_agree)));
    trial.seconds = mean(cheap.seconds, good.seconds);
    trial.error = mean(cheap.error, good.error);
    return trial;
}

/// The position of x between a and b on a logarithmic scale, 0 to 1.
double place_between(double a, double b, double x) {
    constexpr double tiny = 1e-9;
    const double all = std::log(std::max(b, tiny) / std::max(a, tiny));
    return all == 0 ? 0 : std::clamp(std::log(std::max(x, tiny) / std::max(a, tiny)) / all, 0., 1.);
}

/// Returns whether settings between the two are reasonable: they differ in thresholds, or in the
/// number of rays through a pixel.
bool have_a_middle(const Trial& a, const Trial& b) {
    const bool to_shadow_error = a.settings.shadow_error > 0;
    const bool to_pixel_error = a.settings.pixel_error > 0;
    if (to_shadow_error != (b.settings.shadow_error > 0)) return false;
    if (to_pixel_error != (b.settings.pixel_error > 0)) return false;
    return to_shadow_error || to_pixel_error ||
           a.settings.pixel_samples != b.settings.pixel_samples;
}

}  // namespace

void QualityLadder::add(Trial trial) {
    trial.seconds = std::max(trial.seconds, trials_.empty() ? least : top().seconds);
    trials_.push_back(trial);
}

void QualityLadder::extend(const std::vector<RenderSettings>& candidates, double seconds) {
    // Only the rays of the next candidate take longer: their time grows as the error to the power
    // of -4/3. If there are many of them, they take at least half of the time.
    const double without_rays = std::min(trials_.front().seconds, top().seconds / 2);
    for (const RenderSettings& settings : candidates) {
        const Trial last = top();
        if (last.seconds > seconds) return;
        const double rays = (last.seconds - without_rays) * std::exp2(2.0 / 3);
        add({.settings = settings, .seconds = without_rays + rays, .error = last.error});
    }
}

void QualityLadder::shorten(double seconds) {
    for (Trial& trial : trials_) trial.seconds = std::max(trial.seconds - seconds, least);
}

void QualityLadder::end_at(double error) {
    const auto enough =
        std::ranges::find_if(trials_, [=](const Trial& trial) { return trial.error <= error; });
    if (enough != trials_.end()) trials_.erase(std::next(enough), trials_.end());
}

Trial QualityLadder::within_time(double seconds) const {
    const auto dearer =
        std::ranges::find_if(trials_, [=](const Trial& trial) { return trial.seconds > seconds; });
    if (dearer == trials_.begin()) return trials_.front();
    const Trial& fits = *std::prev(dearer);
    if (dearer == trials_.end() || !have_a_middle(fits, *dearer)) return fits;
    return between(fits, *dearer, place_between(fits.seconds, dearer->seconds, seconds));
}

}  // namespace rt
