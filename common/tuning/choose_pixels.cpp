#include "common/tuning/choose_pixels.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/choose_samples.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

namespace rt {

namespace {

/// No error of a pixel is larger: with it, one ray through each pixel is enough.
constexpr double largest_pixel_error = 255;

/// The factor from one error that is tried to the next.
constexpr double error_step = 1.5;

/// The settings with shadow rays that suit an error of a pixel. Their number is fixed: rays that
/// stop once a few agree would make the mean of a pixel wrong, however many rays go through it.
RenderSettings with_shadows(const RenderSettings& settings, bool chosen, double error) {
    if (!chosen) return settings;
    return with_rays(settings, int(std::bit_floor(unsigned(std::clamp(64 / error, 4., 256.)))));
}

RenderSettings with_pixel_samples(RenderSettings settings, int count) {
    settings.pixel_samples = count;
    settings.pixel_error = 0;
    return settings;
}

RenderSettings with_pixel_error(RenderSettings settings, double error) {
    settings.pixel_samples = right_pixel_samples;
    settings.pixel_error = two_digits(error);
    return settings;
}

bool has_choice_of_shadows(const TrialRunner& runner, const Trials& trials) {
    return trials.traits().sized_lights && !runner.aim().given.shadow_samples;
}

/// Trial pixels with their right colors.
class PixelTrials {
public:
    /// The references have an error of an eighth of `error`.
    PixelTrials(TrialRunner& runner, const Trials& trials, const RenderSettings& settings,
                double error)
        : runner_(runner), trials_(trials), reference_(settings) {
        const bool sized_lights = trials.traits().sized_lights;
        if (sized_lights) reference_ = with_rays(reference_, 1);
        reference_.pixel_samples = right_pixel_samples;
        reference_.pixel_error = error / 8;
        // As many rays that agree as in reference_settings: fewer may miss a part of a light.
        at_least_ =
            sized_lights ? int(std::bit_floor(unsigned(std::clamp(200 / error, 32., 256.)))) : 32;
    }

    /// Adds trial pixels.
    void add(const std::vector<Pixel>& pixels) {
        const TrialSample right = runner_.render_pixels(trials_, reference_, pixels, 1, at_least_);
        pixels_.insert(pixels_.end(), pixels.begin(), pixels.end());
        right_.shades.insert(right_.shades.end(), right.shades.begin(), right.shades.end());
    }

    /// Measures settings. Their error is that which one pixel in a hundred exceeds.
    Trial measured(const RenderSettings& settings) {
        const TrialSample sample = runner_.render_pixels(trials_, settings, pixels_, ++round_);
        off_ = distances(sample, right_);
        return {.settings = settings,
                .seconds = runner_.picture_seconds(sample.seconds),
                .rays = sample.rays,
                .error = error_but_for_share(few_pixels, off_)};
    }

    /// The largest mean error of a tile in the last measurement.
    [[nodiscard]] double worst_tile() const {
        constexpr int fewest = 4;
        std::map<int, std::pair<double, int>> tiles;
        for (std::size_t i = 0; i < off_.size(); ++i) {
            auto& [sum, count] = tiles[tile_of(pixels_[i], runner_.size())];
            sum += off_[i];
            ++count;
        }
        double worst = 0;
        for (const auto& [tile, sums] : tiles)
            if (sums.second >= fewest) worst = std::max(worst, sums.first / sums.second);
        return worst;
    }

private:
    TrialRunner& runner_;
    const Trials& trials_;
    RenderSettings reference_;
    int at_least_ = 0;
    int round_ = 1;
    std::vector<Pixel> pixels_;
    TrialSample right_;
    std::vector<double> off_;  ///< of the last measurement
};

/// Trial pixels, spread over the picture: the golden ratio apart, since every k-th of the cells
/// would be in few columns.
std::vector<Pixel> scattered(const TrialRunner& runner, std::size_t count) {
    const std::vector<Pixel> all = runner.spread().pixels();
    if (all.size() <= count) return all;
    constexpr double golden_ratio = 0.6180339887498949;
    std::vector<Pixel> some;
    for (std::size_t i = 0; i < count; ++i) {
        const double place = golden_ratio * double(i);
        some.push_back(all[std::size_t((place - std::floor(place)) * double(all.size()))]);
    }
    return some;
}

}  // namespace

Trial keep_tolerance_of_pixels(TrialRunner& runner, const Trials& trials,
                               const RenderSettings& settings) {
    constexpr std::size_t pixels = 1200;
    const double allowed = *runner.aim().tolerance;
    const bool choose_shadows = has_choice_of_shadows(runner, trials);
    PixelTrials known(runner, trials, settings, allowed);
    known.add(scattered(runner, pixels));
    Trial best{.error = std::numeric_limits<double>::infinity()};
    const auto keeps = [&](const RenderSettings& tried) {
        const Trial trial = known.measured(tried);
        const bool is_kept = trial.error <= allowed && known.worst_tile() <= 2 * allowed;
        if (is_kept || (best.error > allowed && trial.error < best.error)) best = trial;
        return is_kept;
    };
    const auto with_error = [&](double error) {
        return with_pixel_error(with_shadows(settings, choose_shadows, error), error);
    };
    double error = allowed / 2;
    const RenderSettings fine = with_shadows(settings, choose_shadows, error);
    if (keeps(with_pixel_samples(fine, 1))) return best;
    if (keeps(with_error(error))) {
        for (error *= error_step; error < 2 * allowed; error *= error_step)
            if (!keeps(with_error(error))) break;
        return best;
    }
    // An edge of which the rays around it show nothing is not found by a smaller error either.
    for (error /= error_step; error > allowed / 8; error /= error_step)
        if (keeps(with_error(error))) return best;
    for (int count = 64; count <= right_pixel_samples; count *= 2)
        if (keeps(with_pixel_samples(fine, count))) return best;
    return best;
}

QualityLadder measure_pixel_ladder(TrialRunner& runner, const Trials& trials,
                                   const RenderSettings& settings) {
    constexpr std::size_t fewest = 64;
    constexpr std::size_t most = 1024;
    constexpr double finest = 0.5;
    const double time = *runner.aim().time;
    const bool choose_shadows = has_choice_of_shadows(runner, trials);
    PixelTrials known(runner, trials, settings, 1);
    const std::vector<Pixel> pixels = scattered(runner, most);
    const std::size_t parts = std::max<std::size_t>(pixels.size() / fewest, 1);
    for (std::size_t part = 0; part < parts; ++part) {
        std::vector<Pixel> some;
        for (std::size_t i = part; i < pixels.size(); i += parts) some.push_back(pixels[i]);
        known.add(some);
        if (runner.seconds_since_start() > time / 20) break;
    }
    std::vector<RenderSettings> adaptive;
    for (double error = largest_pixel_error; error >= finest;
         error = std::min(error, 32 * std::sqrt(2)) / std::sqrt(2))
        adaptive.push_back(with_pixel_error(with_shadows(settings, choose_shadows, error), error));
    QualityLadder ladder;
    for (std::size_t i = 0; i < adaptive.size(); ++i) {
        ladder.add(known.measured(adaptive[i]));
        if (ladder.top().seconds > time) return ladder;
        if (!runner.no_time_left()) continue;
        ladder.extend({adaptive.begin() + std::ptrdiff_t(i) + 1, adaptive.end()}, time);
        return ladder;
    }
    // There is time for more than adaptive sampling can use: it does not find every edge.
    QualityLadder whole;
    for (int count = 64; count <= right_pixel_samples; count *= 2) {
        whole.add(known.measured(
            with_pixel_samples(with_shadows(settings, choose_shadows, finest), count)));
        if (whole.top().seconds > time || runner.no_time_left()) break;
    }
    const Trial fits = whole.within_time(time);
    return fits.seconds <= time && fits.error < ladder.top().error ? whole : ladder;
}

std::string pixels_in_words(const RenderSettings& settings) {
    if (settings.pixel_error > 0 && settings.pixel_error < largest_pixel_error)
        return "more than one beside edges, until the estimated error is below " +
               levels(settings.pixel_error);
    return settings.pixel_samples == 1 || settings.pixel_error > 0
               ? "1, through the center"
               : std::to_string(settings.pixel_samples);
}

}  // namespace rt
