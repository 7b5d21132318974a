#include "common/tuning/trial_runner.hpp"

#include "common/tuning/candidates.hpp"

#include <limits>

namespace rt {

double TrialRunner::limit() const {
    constexpr double unseen = 0.5;  // rounding to the picture's colors has an error of half a level
    return aim_.tolerance.value_or(unseen);
}

TrialSample TrialRunner::render_pixels(const Trials& trials, const RenderSettings& settings,
                                       std::span<const Pixel> pixels, int round) {
    TrialSample sample = trials.render_pixels(
        settings, {.pixels = pixels, .round = round, .threads = aim_.threads, .stop = &stop_});
    check_stop();
    drawn_ += pixels.size();
    rays_ += sample.rays * double(pixels.size());
    return sample;
}

TrialHistories TrialRunner::trace_histories(const Trials& trials, const RenderSettings& settings,
                                            TrialRequest request) {
    request.threads = aim_.threads;
    request.stop = &stop_;
    TrialHistories histories = trials.trace_histories(settings, request);
    check_stop();
    drawn_ += request.pixels.size();
    rays_ += histories.rays;
    return histories;
}

TrialCenters TrialRunner::render_centers(Trials& trials, const RenderSettings& settings) {
    const double start = seconds_since_start();
    const TrialCenters centers =
        trials.render_centers(settings, {.threads = aim_.threads, .stop = &stop_});
    check_stop();
    center_seconds_ = seconds_since_start() - start;
    center_rays_ = centers.rays;
    return centers;
}

double TrialRunner::picture_seconds(double of_a_pixel) const {
    return of_a_pixel * pixels() / aim_.threads;
}

double TrialRunner::seconds_since_start() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void TrialRunner::check_stop() const {
    if (stop_) throw Stopped();
}

double TrialRunner::seconds_for_trials() const {
    return aim_.time ? *aim_.time / 10 : std::numeric_limits<double>::infinity();
}

RenderSettings with_one_shadow_ray(RenderSettings settings, const Aim& aim) {
    return aim.given.shadow_samples ? settings : with_rays(settings, 1);
}

CheaperPicture with_few_rays(RenderSettings settings) {
    constexpr int few = 16;
    if (settings.pixel_error > 0 || settings.pixel_samples <= few) return {.settings = settings};
    const double times = double(settings.pixel_samples) / few;
    settings.pixel_samples = few;
    return {.settings = settings, .times = times};
}

}  // namespace rt
