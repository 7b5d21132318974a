#include "common/tuning/pixel_study.hpp"

#include "common/math/spread_order.hpp"
#include "common/tuning/candidates.hpp"
#include "common/tuning/contrast.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/promise.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

namespace rt {

namespace {

DisplayColor display_color(const Rgb& rgb) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (rgb == not_a_color) return {nan, nan, nan};
    return {double(rgb[0]), double(rgb[1]), double(rgb[2])};
}

/// The number of pixels that one pixel stands for, in which the first few rays found a difference
/// from the center: in the others they missed it, as the center did.
double pixels_missed(double off, double range) {
    const double part = off / std::max({off, range, 1.0});
    return 1 / (1 - std::pow(1 - std::min(part, 1.0), PixelHistory::fewest));
}

/// With N rays, the square of an error is N^(−1.5) on an edge, and about N^(−1.2) in a soft shadow.
constexpr double fall = 1.5;
constexpr double soft_fall = 1.2;

}  // namespace

PixelStudy::PixelStudy(TrialRunner& runner, Trials& trials, const RenderSettings& settings,
                       double allowed, bool soft)
    : soft_(soft),
      runner_(runner),
      trials_(trials),
      settings_(settings),
      reference_(settings),
      allowed_(allowed),
      centers_(runner.render_centers(trials, settings)),
      strata_{{{.at_least = 32, .first = 64},
               {.at_least = 16, .first = 128},
               {.at_least = PixelHistory::fewest, .first = 512}}} {
    constexpr std::size_t enough = 4096;
    constexpr double fewest_pixels = 48;
    reference_.pixel_samples = int(std::bit_floor(unsigned(
        std::clamp<double>(rays_in(seconds_left()) / fewest_pixels, 8, right_pixel_samples))));
    while (sorted_ < enough && sort_more()) {
    }
}

bool PixelStudy::sort_more() {
    if (draws_ == runner_.spread().draws()) return false;
    std::array<std::vector<Pixel>, kinds> places;
    for (const Pixel pixel : runner_.spread().pixels(draws_++)) {
        places[stratum_of(pixel)].push_back(pixel);
        ++sorted_;
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        Stratum& stratum = strata_[kind];
        // Each part is spread over the picture: every k-th cell of a grid is in few columns.
        for (const std::size_t i : spread_order(places[kind].size()))
            stratum.places.push_back(places[kind][i]);
        stratum.pixels = runner_.pixels() * double(stratum.places.size()) / double(sorted_);
    }
    return true;
}

std::size_t PixelStudy::stratum_of(Pixel pixel) const {
    if (contrast_around(*centers_.image, pixel, 1) <= allowed_) return 2;  // most pixels
    return contrast_around(*centers_.image, pixel, 0) > 8 * allowed_ ? 0 : 1;
}

void PixelStudy::begin(double right_error) {
    reference_.pixel_error = right_error;
    tiles_.clear();
    for (Stratum& stratum : strata_) {
        stratum.traced.clear();
        stratum.rays = 0;
    }
    trace_first();
}

void PixelStudy::trace_first() {
    double left = kinds;
    for (Stratum& stratum : strata_) {
        if (stratum.traced.empty()) trace_up_to(stratum.first, stratum, 1 / left);
        --left;
    }
}

void PixelStudy::grow(std::size_t kind) {
    Stratum& stratum = strata_[kind];
    const std::size_t known = stratum.traced.size();
    if (stratum.places.size() < 2 * known) sort_more();
    while (stratum.places.size() == known && sort_more()) {
    }
    trace_up_to(2 * known, stratum, 1);
    trace_first();  // of kinds of which the first pixels were sorted just now
}

double PixelStudy::seconds_left() const {
    return std::max(runner_.seconds_for_trials() - seconds_, 0.);
}

double PixelStudy::rays_in(double seconds) const {
    return seconds / std::max(centers_.seconds, 1e-12);
}

void PixelStudy::trace_up_to(std::size_t wanted, Stratum& stratum, double part) {
    const double start = seconds_;
    const double end = start + part * seconds_left();
    const int at_least = std::min(stratum.at_least, reference_.pixel_samples);
    const std::size_t count = std::min(wanted, stratum.places.size());
    const std::size_t before = stratum.traced.size();
    std::size_t known = before;
    // A pixel may take as many rays as the right one; after the first few, what they took is known.
    double pixels = rays_in(end - start) / reference_.pixel_samples;
    while (known < count && (known == before || seconds_ < end)) {
        const auto next = std::size_t(std::clamp(pixels, 1., double(count - known)));
        std::vector<TrialPixel> more =
            traced(std::span(stratum.places).subspan(known, next), at_least);
        for (const TrialPixel& pixel : more) stratum.rays += pixel.steps.back().rays;
        std::ranges::move(more, std::back_inserter(stratum.traced));
        known += next;
        const double tried = double(known - before);
        pixels = std::min(tried, tried * (end - seconds_) / std::max(seconds_ - start, 1e-12));
    }
}

double PixelStudy::Outcome::at_most() const {
    // That all kinds are at their worst at once is less likely (Zou and Donner 2008).
    return beyond + std::hypot(doubts[0], doubts[1], doubts[2]);
}

std::optional<PixelStudy::Growth> PixelStudy::growth(const Outcome& outcome, double share) const {
    Outcome later = outcome;
    std::array<double, kinds> times{1, 1, 1};  // as many trial pixels as now
    std::optional<Growth> all;
    while (later.at_most() > share) {
        std::optional<std::size_t> best;
        const auto worth = [&](std::size_t kind) {
            return later.doubts[kind] * later.doubts[kind] / (strata_[kind].rays * times[kind]);
        };
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            const bool has_more =
                double(strata_[kind].traced.size()) * times[kind] < strata_[kind].pixels;
            if (has_more && (!best || worth(kind) > worth(*best))) best = kind;
        }
        if (!best || later.beyond >= share) return {};
        if (!all) all = {.kind = *best};
        all->rays += strata_[*best].rays * times[*best];
        times[*best] *= 2;
        later.doubts[*best] /= std::sqrt(2);
    }
    return all;
}

std::vector<PixelStudy::TrialPixel> PixelStudy::traced(std::span<const Pixel> places,
                                                       int at_least) {
    TrialHistories histories = runner_.trace_histories(trials_, reference_, places, at_least);
    spent_ += histories.rays;
    seconds_ += histories.seconds;
    std::vector<TrialPixel> pixels;
    for (std::size_t i = 0; i < places.size(); ++i)
        pixels.push_back(compared(places[i], std::move(histories.pixels[i]), at_least));
    return pixels;
}

PixelStudy::TrialPixel PixelStudy::compared(Pixel place, PixelHistory history, int at_least) const {
    const PixelStep& right = history.steps.back();
    const DisplayColor center = display_color((*centers_.image)[place]);
    TrialPixel pixel{.place = place,
                     .contrast = contrast_around(*centers_.image, place, 1),
                     .center_off = distance(center, right.mean)};
    // The ray through the center sends as many rays to a light as 4 of the others together. In a
    // penumbra, the difference contains the errors of both.
    const bool few_rays = at_least == PixelHistory::fewest;
    if (soft_ && !few_rays)
        pixel.center_off /= std::sqrt(1 + std::pow(4.0 / right.count, soft_fall));
    if (few_rays && history.steps.size() > 1)
        pixel.center_seen = pixels_missed(pixel.center_off, history.range);
    for (const PixelStep& step : history.steps) {
        // The right color contains the same rays, so that its difference from their mean is smaller
        // than the error of that.
        const double others =
            1 - std::pow(double(step.count) / right.count, soft_ ? soft_fall : fall);
        pixel.offs.push_back(others > 0 ? distance(step.mean, right.mean) / std::sqrt(others) : 0);
    }
    pixel.steps = std::move(history.steps);
    return pixel;
}

PixelStudy::Result PixelStudy::result(const TrialPixel& pixel, const RenderSettings& settings) {
    const bool adaptive = settings.pixel_error > 0;
    if (adaptive ? pixel.contrast <= int(2 * settings.pixel_error) : settings.pixel_samples == 1)
        return {.error = pixel.center_off, .pixels = pixel.center_seen};
    const std::vector<PixelStep>& steps = pixel.steps;
    int count = adaptive ? first_pixel_samples(settings.pixel_error) : settings.pixel_samples;
    std::size_t step = PixelHistory::step_of(count);
    while (adaptive && step < steps.size() && steps[step].error > settings.pixel_error &&
           count < settings.pixel_samples) {
        count = next_pixel_samples(count, settings.pixel_samples);
        step = PixelHistory::step_of(count);
    }
    if (step >= steps.size()) return {.rays = steps.back().rays * count / steps.back().count};
    return {.error = pixel.offs[step], .rays = steps[step].rays};
}

Trial PixelStudy::trial(const RenderSettings& settings) const {
    const double more = outcome(settings, allowed_).rays / runner_.pixels();
    const double seconds_of_a_ray = seconds_ / std::max(spent_, 1.0);
    Trial trial{.settings = settings,
                .seconds = runner_.picture_seconds(centers_.seconds + more * seconds_of_a_ray),
                .rays = centers_.rays + more,
                .error = largest_pixel_error};
    const double step = std::sqrt(2);
    while (trial.error > reference_.pixel_error &&
           outcome(settings, trial.error / step).at_most() <= few_pixels)
        trial.error /= step;
    return trial;
}

PixelStudy::Outcome PixelStudy::outcome(const RenderSettings& settings, double allowed) const {
    Outcome outcome;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const Stratum& stratum = strata_[kind];
        if (stratum.places.empty()) continue;
        double beyond = 0;
        double rays = 0;
        for (const TrialPixel& pixel : stratum.traced) {
            const Result with = result(pixel, settings);
            rays += with.rays;
            beyond += with.pixels * chance_beyond(with.error, allowed);
        }
        const auto tried = double(stratum.traced.size());
        const double part = stratum.pixels / runner_.pixels();
        outcome.rays += rays / tried * stratum.pixels;
        outcome.beyond += part * beyond / tried;
        outcome.doubts[kind] =
            part * (largest_share(beyond, tried, stratum.pixels) - beyond / tried);
    }
    return outcome;
}

bool PixelStudy::tiles_keep(const RenderSettings& settings, double allowed) {
    constexpr double pixels = double(tile_side) * tile_side;
    std::map<int, double> errors;  // sums over the pixels of a tile, estimated
    for (const Stratum& stratum : strata_)
        for (const TrialPixel& pixel : stratum.traced) {
            const Result with = result(pixel, settings);
            errors[tile_of(pixel.place, runner_.size())] +=
                with.error * with.pixels * stratum.pixels / double(stratum.traced.size());
        }
    return std::ranges::all_of(errors, [&](const auto& tile) {
        return tile.second <= allowed * pixels || tile_keeps(tile.first, settings, allowed);
    });
}

bool PixelStudy::tile_keeps(int tile, const RenderSettings& settings, double allowed) {
    constexpr std::size_t enough = 64;
    std::vector<TrialPixel>& tried = tiles_[tile];
    if (tried.empty()) {
        std::vector<Pixel> places;
        for (int draw = 0; places.size() < enough && draw < runner_.spread().draws(); ++draw)
            std::ranges::copy_if(
                runner_.spread().pixels(draw), std::back_inserter(places),
                [&](Pixel pixel) { return tile_of(pixel, runner_.size()) == tile; });
        tried = traced(places, strata_[0].at_least);
    }
    double errors = 0;
    for (const TrialPixel& pixel : tried) errors += result(pixel, settings).error;
    return errors <= allowed * double(tried.size());
}

}  // namespace rt
