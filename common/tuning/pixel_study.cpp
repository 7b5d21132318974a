#include "common/tuning/pixel_study.hpp"

#include "common/math/spread_order.hpp"
#include "common/tuning/candidates.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <map>

namespace rt {

namespace {

/// Sets the errors of the means of both runs, of which each is compared with the last of the other.
/// That has an error too: with N rays, its mean square is N^-1.5 on an edge, and N^-1 for noise.
void set_errors(PixelHistory& history) {
    for (std::size_t run = 0; run < 2; ++run)
        for (PixelStep& step : history.runs[run]) {
            const PixelStep& right = history.runs[1 - run].back();
            const double fewer = double(step.count) / right.count;
            step.off = distance(step.mean, right.mean) / std::sqrt(1 + fewer * std::sqrt(fewer));
        }
}

/// The rays to a light of each ray through a trial pixel (pixel_samples.hpp, adaptive_settings).
constexpr int of_each_ray(int shadow_samples) {
    return (shadow_samples + 3) / 4;
}

/// Pixels with smaller details are too few to break the promise.
constexpr double very_few = few_pixels / 10;

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
      fine_(trials.fine_shapes()),
      strata_{{{.at_least = 8, .scouts = 16, .first = 64},
               {.at_least = 8, .scouts = 8, .first = 128},
               {.at_least = 8, .scouts = PixelHistory::fewest, .first = 512},
               {.at_least = 32, .first = 128}}} {
    constexpr std::size_t enough = 4096;
    constexpr double fewest_pixels = 64;
    reference_.pixel_samples = int(std::bit_floor(unsigned(std::clamp<double>(
        rays_in(seconds_left()) / (2 * fewest_pixels), 8, right_pixel_samples))));
    expect_details(trials.traits());
    while (sorted_ < enough && sort_more()) {
    }
}

void PixelStudy::expect_details(const SceneTraits& traits) {
    std::vector<float> parts;
    std::ranges::copy_if(fine_.parts, std::back_inserter(parts),
                         [](float part) { return part < 1; });
    if (!fine_.matter()) return fine_.parts.clear();
    const auto least = parts.begin() + std::ptrdiff_t(very_few * runner_.pixels());
    std::ranges::nth_element(parts, least);
    // A detail that every ray misses does not matter if it changes no pixel by more than the
    // tolerance.
    const double part = std::max(double(*least), allowed_ / 255);
    constexpr double most_found = 3;  // that every ray misses it is then 5 % likely
    strata_[3].at_least = int(std::clamp(most_found / part, 32.0, double(right_pixel_samples)));
    elsewhere_ = (traits.shadows || traits.strongest_mirror > 0) &&
                 double(parts.size()) > few_pixels * runner_.pixels();
    if (!elsewhere_) return;
    Stratum& others = strata_[2];
    others.scouts = int(std::bit_ceil(unsigned(std::clamp(1 / part, 4.0, 64.0))));
    others.unseen = 1 / (1 - std::pow(1 - std::min(part, 0.5), others.scouts));
}

std::string PixelStudy::details() const {
    if (fine_.parts.empty()) return "";
    const Stratum& fine = strata_[3];
    std::string text = "a " + fine_.narrowest + " is " + number(fine_.width) +
                       " pixels wide: trial pixels on such shapes get " +
                       std::to_string(fine.at_least) + " rays";
    if (fine.at_least == right_pixel_samples)
        text += "; what covers less than 1/" + std::to_string(fine.at_least / 3) +
                " of a pixel is missed, and not promised";
    if (elsewhere_)
        text += "; their shadows and reflections are found from 1/" +
                std::to_string(2 * strata_[2].scouts) + " of a pixel on";
    return text;
}

RenderSettings PixelStudy::with_pixel_samples(int count) const {
    RenderSettings settings = settings_;
    settings.pixel_samples = count;
    settings.pixel_error = 0;
    if (soft_ && count > 1)
        settings.shadow_samples = int(of_each_ray(settings_.shadow_samples) * std::sqrt(count));
    return settings;
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
    const auto place =
        std::size_t(pixel.row) * std::size_t(runner_.size().width) + std::size_t(pixel.column);
    if (!fine_.parts.empty() && fine_.parts[place] < 1) return 3;
    if (contrast_around(*centers_.image, pixel, 1) <= allowed_) return 2;  // most pixels
    return contrast_around(*centers_.image, pixel, 0) > 8 * allowed_ ? 0 : 1;
}

void PixelStudy::begin(double right_error) {
    reference_.pixel_error = right_error;
    tiles_.clear();
    for (Stratum& stratum : strata_) {
        stratum.traced.clear();
        stratum.known.clear();
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
    const double rays_before = spent_;
    const double end = start + part * seconds_left();
    const int at_least = std::min(stratum.at_least, reference_.pixel_samples);
    const std::size_t count = std::min(wanted, stratum.places.size());
    const std::size_t before = stratum.traced.size();
    std::size_t known = before;
    // Both runs may take as many rays as the right color; after the first few pixels, what they
    // took is known.
    double pixels = rays_in(end - start) / (2 * reference_.pixel_samples);
    while (known < count && (known == before || seconds_ < end)) {
        const auto next = std::size_t(std::clamp(pixels, 1., double(count - known)));
        std::vector<TrialPixel> more =
            traced(std::span(stratum.places).subspan(known, next), at_least, stratum.scouts);
        std::ranges::move(more, std::back_inserter(stratum.traced));
        stratum.known.clear();
        known += next;
        const double tried = double(known - before);
        pixels = std::min(tried, tried * (end - seconds_) / std::max(seconds_ - start, 1e-12));
    }
    stratum.rays += spent_ - rays_before;
}

double PixelStudy::Outcome::at_most() const {
    // That all kinds are at their worst at once is less likely (Zou and Donner 2008).
    return beyond + std::hypot(std::hypot(doubts[0], doubts[1]), std::hypot(doubts[2], doubts[3]));
}

std::optional<PixelStudy::Growth> PixelStudy::growth(const Outcome& outcome, double share) const {
    Outcome later = outcome;
    std::array<double, kinds> times{1, 1, 1, 1};  // as many trial pixels as now
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

std::vector<PixelStudy::TrialPixel> PixelStudy::traced(std::span<const Pixel> places, int at_least,
                                                       int scouts) {
    TrialHistories histories =
        runner_.trace_histories(trials_, reference_,
                                {.pixels = places,
                                 .at_least = at_least,
                                 .scouts = std::min(scouts, reference_.pixel_samples),
                                 .centers = centers_.image,
                                 .visible = allowed_ / 4});
    spent_ += histories.rays;
    seconds_ += histories.seconds;
    std::vector<TrialPixel> pixels;
    for (std::size_t i = 0; i < places.size(); ++i) {
        PixelHistory& history = histories.pixels[i];
        const DisplayColor center = display_color((*centers_.image)[places[i]]);
        const double off = history.is_traced() ? distance(center, history.mean()) : 0;
        set_errors(history);
        pixels.push_back({.place = places[i],
                          .contrast = std::max(contrast_around(*centers_.image, places[i], 1),
                                               int(history.followed)),
                          .center_off = off,
                          .history = std::move(history)});
    }
    return pixels;
}

PixelStudy::Result PixelStudy::result(const TrialPixel& pixel, std::size_t run,
                                      const RenderSettings& settings) {
    const std::vector<PixelStep>& steps = pixel.history.runs[run];
    const bool adaptive = settings.pixel_error > 0;
    if (adaptive ? pixel.contrast <= int(2 * settings.pixel_error) : settings.pixel_samples == 1)
        return {.error = pixel.center_off};
    int count = adaptive
                    ? std::min(first_pixel_samples(settings.pixel_error), settings.pixel_samples)
                    : settings.pixel_samples;
    const double ray_rays = pixel.history.ray_rays;
    if (steps.empty()) return {.rays = ray_rays * count};
    std::size_t step = PixelHistory::step_of(count);
    while (adaptive && step < steps.size() && steps[step].error > settings.pixel_error &&
           count < settings.pixel_samples) {
        count = next_pixel_samples(count, settings.pixel_samples);
        step = PixelHistory::step_of(count);
    }
    const PixelStep& last = steps[std::min(step, steps.size() - 1)];
    return {.error = last.off * std::sqrt(double(last.count) / std::max(count, last.count)),
            .rays = step < steps.size() ? steps[step].rays : ray_rays * count};
}

Trial PixelStudy::trial(const RenderSettings& settings) const {
    const Outcome expected = outcome(settings);
    const double more = expected.rays / runner_.pixels();
    const double seconds_of_a_ray = seconds_ / std::max(spent_, 1.0);
    Trial trial{.settings = settings,
                .seconds = runner_.picture_seconds(centers_.seconds + more * seconds_of_a_ray),
                .rays = centers_.rays + more,
                .error = largest_pixel_error,
                .beyond = expected.beyond,
                .at_most = expected.at_most()};
    const double step = std::sqrt(2);
    while (trial.error > reference_.pixel_error &&
           outcome(settings, trial.error / step).at_most() <= few_pixels)
        trial.error /= step;
    return trial;
}

PixelStudy::Sums PixelStudy::sums(const Stratum& stratum, const RenderSettings& settings,
                                  double allowed) {
    Sums sums{.squares = stratum.unseen};  // as if one more were
    for (const TrialPixel& pixel : stratum.traced) {
        double beyond = 0;
        for (std::size_t run = 0; run < 2; ++run) {
            const Result with = result(pixel, run, settings);
            sums.rays += with.rays / 2;
            beyond += pixel.history.stands_for * chance_beyond(with.error, allowed) / 2;
        }
        sums.beyond += beyond;
        sums.squares += beyond * beyond;
    }
    return sums;
}

PixelStudy::Outcome PixelStudy::outcome(const RenderSettings& settings, double allowed) const {
    Outcome outcome;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const Stratum& stratum = strata_[kind];
        if (stratum.places.empty()) continue;
        const auto [known, is_new] = stratum.known.try_emplace(
            {settings.pixel_error, double(settings.pixel_samples), allowed});
        if (is_new) known->second = sums(stratum, settings, allowed);
        const auto [rays, beyond, squares] = known->second;
        // Pixels that stand for k are as uncertain as if there were 1/k of them (Kish 1965).
        const double stands_for = squares / (1 + beyond);
        const auto tried = double(stratum.traced.size());
        const double part = stratum.pixels / runner_.pixels();
        outcome.rays += rays / tried * stratum.pixels;
        outcome.beyond += part * beyond / tried;
        outcome.doubts[kind] = part * (largest_share(beyond / stands_for, tried / stands_for,
                                                     stratum.pixels / stands_for) -
                                       beyond / tried);
    }
    return outcome;
}

bool PixelStudy::tiles_keep(const RenderSettings& settings, double allowed) {
    constexpr double pixels = double(tile_side) * tile_side;
    std::map<int, double> errors;  // sums over the pixels of a tile, estimated
    for (const Stratum& stratum : strata_)
        for (const TrialPixel& pixel : stratum.traced) {
            errors[tile_of(pixel.place, runner_.size())] +=
                result(pixel, 0, settings).error * pixel.history.stands_for * stratum.pixels /
                double(stratum.traced.size());
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
        tried = traced(places, strata_[0].at_least, 0);
    }
    double errors = 0;
    for (const TrialPixel& pixel : tried) errors += result(pixel, 0, settings).error;
    return errors <= allowed * double(tried.size());
}

}  // namespace rt
