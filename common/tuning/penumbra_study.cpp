#include "common/tuning/penumbra_study.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/promise.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace rt {

namespace {

constexpr int first_round = 500;  // of looks that are compared

double mean(const std::vector<int>& counts) {
    const double all = std::reduce(counts.begin(), counts.end(), 0.);
    return counts.empty() ? 0 : all / double(counts.size());
}

double share_of(std::size_t some, std::size_t all) {
    return all > 0 ? double(some) / double(all) : 0;
}

}  // namespace

PenumbraStudy::PenumbraStudy(TrialRunner& runner, const Trials& trials,
                             const RenderSettings& settings, double allowed)
    : runner_(runner),
      trials_(trials),
      allowed_(allowed),
      reference_(reference_settings(settings, allowed)),
      penumbrae_(find_penumbrae(runner, trials, settings)) {
    const RenderSettings one_ray = with_rays(settings, 1);
    const TrialSample clear = render_pixels(one_ray, some_of(penumbrae_.clear, 128), ++round_);
    without_light_rays_ = clear.rays - mean(clear.light_rays);
    seconds_of_a_ray_ = clear.rays > 0 ? clear.seconds / clear.rays : 0;
    sort_doubtful(one_ray);
}

/// Sorts the doubtful pixels into those in a penumbra and those whose light rays all agree.
void PenumbraStudy::sort_doubtful(const RenderSettings& one_ray) {
    const double wanted = std::clamp(penumbrae_.share * runner_.pixels() / 64, 128., 1000.);
    const std::vector<Pixel> doubtful = some_of(penumbrae_.doubtful, std::size_t(wanted));
    const TrialSample right = render_pixels(reference_, doubtful, ++round_);
    const std::vector<double> off = distances(render_pixels(one_ray, doubtful, ++round_), right);
    std::vector<Pixel> calm = penumbrae_.asked;
    for (std::size_t i = 0; i < doubtful.size(); ++i)
        if (off[i] > allowed_) {
            pixels_.push_back(doubtful[i]);
            right_.shades.push_back(right.shades[i]);
        } else if (right.light_rays[i] > 0) {
            calm.push_back(doubtful[i]);
        }
    share_ = penumbrae_.share * share_of(pixels_.size(), doubtful.size());
    const std::size_t doubtful_calm = calm.size() - penumbrae_.asked.size();
    calm_share_ =
        penumbrae_.share * share_of(doubtful_calm, doubtful.size()) +
        (1 - penumbrae_.share) * share_of(penumbrae_.asked.size(), penumbrae_.clear.size());
    calm_ = some_of(calm, 32);
}

TrialSample PenumbraStudy::render_pixels(const RenderSettings& settings,
                                         const std::vector<Pixel>& pixels, int round) {
    TrialSample sample = runner_.render_pixels(trials_, settings, pixels, round);
    rays_spent_ += sample.rays * double(pixels.size());
    return sample;
}

/// The fraction of the pixels in penumbras that may exceed the tolerance on average, so that the
/// random rays of the final picture do not break the promise: with more confidence than the trials
/// have, because both must be right.
double PenumbraStudy::few() const {
    const double promised = std::min(few_in_penumbrae, few_pixels / std::max(share_, few_pixels));
    return pixels() < 1
               ? promised
               : double(allowed_outliers(std::size_t(pixels()), promised, certain_99)) / pixels();
}

PenumbraStudy::Judged PenumbraStudy::judged(RenderSettings settings, std::size_t fewest) {
    if (settings.shadow_error > 0) settings.shadow_error = two_digits(settings.shadow_error);
    Judged result{.trial = {.settings = settings}};
    int round = first_round;
    judge(result, fewest, round);
    return result;
}

void PenumbraStudy::judge_again(Judged& judged) {
    constexpr std::size_t fewest = 64;
    judge(judged, fewest, round_);
}

/// Adds samples, one at least, until `distances_known` errors of pixels are known, and measures the
/// cost and the error of the settings.
void PenumbraStudy::judge(Judged& judged, std::size_t distances_known, int& round) {
    const RenderSettings& settings = judged.trial.settings;
    TrialSample next;
    do {
        next = render_pixels(settings, pixels_, ++round);
        for (const double off : distances(next, right_))
            judged.off.push_back(off / reference_bias(settings, reference_));
    } while (!pixels_.empty() && judged.off.size() < distances_known);
    judged.trial.error = error_but_for_share(few(), judged.off);
    set_cost(judged.trial, next);
}

/// Computes the cost of the settings from the pixels in penumbras and the others.
void PenumbraStudy::set_cost(Trial& trial, const TrialSample& in_penumbrae) {
    const double light_rays =
        calm_share_ * mean(render_pixels(trial.settings, calm_, first_round).light_rays);
    const double elsewhere = light_rays + (1 - share_) * without_light_rays_;
    trial.rays = share_ * in_penumbrae.rays + elsewhere;
    // Outside penumbras, rays to a light take about as long as inside.
    const double of_a_ray =
        in_penumbrae.rays > 0 ? in_penumbrae.seconds / in_penumbrae.rays : seconds_of_a_ray_;
    trial.seconds = runner_.picture_seconds(share_ * in_penumbrae.seconds + light_rays * of_a_ray +
                                            (elsewhere - light_rays) * seconds_of_a_ray_);
}

bool PenumbraStudy::worst_tile_keeps(const Judged& judged) {
    std::map<int, int> beyond;
    for (std::size_t i = 0; i < judged.off.size(); ++i)
        if (judged.off[i] > allowed_)
            ++beyond[tile_of(pixels_[i % pixels_.size()], runner_.size())];
    const auto worst =
        std::ranges::max_element(beyond, {}, [](const auto& tile) { return tile.second; });
    if (worst == beyond.end() || worst->second < 2) return true;
    const auto is_there = [&](Pixel pixel) {
        return tile_of(pixel, runner_.size()) == worst->first;
    };
    std::vector<Pixel> pixels;
    std::ranges::copy_if(penumbrae_.doubtful, std::back_inserter(pixels), is_there);
    const auto clear = double(std::ranges::count_if(penumbrae_.clear, is_there));
    const double most_beyond = few_in_a_tile * (double(pixels.size()) + clear * penumbrae_.draws);
    if (double(pixels.size()) <= most_beyond) return true;
    const RenderSettings& settings = judged.trial.settings;
    const TrialSample right = render_pixels(reference_, pixels, ++round_);
    const std::vector<double> off = distances(render_pixels(settings, pixels, ++round_), right);
    const double allowed = allowed_ * reference_bias(settings, reference_);
    return double(std::ranges::count_if(off, [=](double d) { return d > allowed; })) <= most_beyond;
}

}  // namespace rt
