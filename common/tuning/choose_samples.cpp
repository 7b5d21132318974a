#include "common/tuning/choose_samples.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/penumbrae.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

namespace rt {

namespace {

/// Settings measured on pixels in penumbras.
struct Judged {
    Trial trial;
    std::vector<double> off;  ///< error of each pixel, for each sample in turn
};

class Sampling {
public:
    Sampling(TrialRunner& runner, const Trials& trials, const RenderSettings& settings)
        : runner_(runner),
          trials_(trials),
          allowed_(*runner.aim().tolerance),
          settings_(settings),
          reference_(reference_settings(settings, allowed_)),
          penumbrae_(find_penumbrae(runner, trials, settings)) {
        const TrialSample clear =
            render_pixels(with_rays(settings, 1), some_of(penumbrae_.clear, 128), ++round_);
        without_light_rays_ = clear.rays - mean(clear.light_rays);
        seconds_of_a_ray_ = clear.rays > 0 ? clear.seconds / clear.rays : 0;
        sort_doubtful();
    }

    [[nodiscard]] Trial best() {
        if (share_ > 0 && share_ * runner_.pixels() < fewest_pixels) return untried();
        for (const int rays : {1, 2, 4}) {
            const Judged few = judged(with_rays(settings_, rays));
            if (keeps(few)) return confirmed(few);
            if (few.trial.error > 4 * allowed_) break;  // more than four times the rays can reduce
        }
        return confirmed(found());
    }

private:
    /// Sorts the doubtful pixels into those in a penumbra and those whose light rays all agree.
    void sort_doubtful() {
        const double wanted = std::clamp(penumbrae_.share * runner_.pixels() / 64, 128., 1000.);
        const std::vector<Pixel> doubtful = some_of(penumbrae_.doubtful, std::size_t(wanted));
        const TrialSample right = render_pixels(reference_, doubtful, ++round_);
        const std::vector<double> off =
            distances(render_pixels(with_rays(settings_, 1), doubtful, ++round_), right);
        std::vector<Pixel> calm = penumbrae_.asked;
        for (std::size_t i = 0; i < doubtful.size(); ++i)
            if (off[i] > allowed_) {
                pixels_.push_back(doubtful[i]);
                right_.shades.push_back(right.shades[i]);
            } else if (right.light_rays[i] > 0) {
                calm.push_back(doubtful[i]);
            }
        const auto share_of = [](std::size_t some, std::size_t all) {
            return all > 0 ? double(some) / double(all) : 0;
        };
        share_ = penumbrae_.share * share_of(pixels_.size(), doubtful.size());
        const std::size_t doubtful_calm = calm.size() - penumbrae_.asked.size();
        calm_share_ =
            penumbrae_.share * share_of(doubtful_calm, doubtful.size()) +
            (1 - penumbrae_.share) * share_of(penumbrae_.asked.size(), penumbrae_.clear.size());
        calm_ = some_of(calm, 32);
    }

    TrialSample render_pixels(const RenderSettings& settings, const std::vector<Pixel>& pixels,
                              int round) {
        TrialSample sample = runner_.render_pixels(trials_, settings, pixels, round);
        rays_spent_ += sample.rays * double(pixels.size());
        return sample;
    }

    /// Returns whether better settings would save less than more trials cost.
    [[nodiscard]] bool has_tried_enough(const Trial& best) const {
        return rays_spent_ > 0.06 * best.rays * runner_.pixels();
    }

    [[nodiscard]] static double mean(const std::vector<int>& counts) {
        const double all = std::reduce(counts.begin(), counts.end(), 0.);
        return counts.empty() ? 0 : all / double(counts.size());
    }

    [[nodiscard]] bool keeps(const Judged& judged) const { return judged.trial.error <= allowed_; }

    [[nodiscard]] bool is_better(const Judged& a, const Judged& b) const {
        if (keeps(a) != keeps(b)) return keeps(a);
        return keeps(a) ? a.trial.rays < b.trial.rays : a.trial.error < b.trial.error;
    }

    /// The smallest error that is tried: a smaller one changes nothing that counts.
    [[nodiscard]] double least_error() const { return two_digits(0.35 * allowed_); }

    /// The error at which sampling can stop, if visibility_error (stage 11) estimates it correctly.
    /// It is smaller if more of the picture is in a penumbra, because then a smaller fraction of
    /// those pixels may exceed the tolerance.
    [[nodiscard]] double likely_error() const {
        return allowed_ * std::clamp(0.85 - share_ / 2, 0.45, 0.7);
    }

    /// The fraction of the pixels in penumbras that may exceed the tolerance on average, so that
    /// the random rays of the final picture do not break the promise: with more confidence than
    /// the trials have, because both must be right.
    [[nodiscard]] double few() const {
        const double all = share_ * runner_.pixels();
        const double promised =
            std::min(few_in_penumbrae, few_pixels / std::max(share_, few_pixels));
        return all < 1 ? promised
                       : double(allowed_outliers(std::size_t(all), promised, certain_99)) / all;
    }

    Judged judged(RenderSettings settings, std::size_t fewest = 64) {
        if (settings.shadow_error > 0) settings.shadow_error = two_digits(settings.shadow_error);
        Judged result{.trial = {.settings = settings}};
        int round = first_round;  // all settings are compared with the same rays
        judge(result, fewest, round);
        return result;
    }

    /// Adds samples, one at least, until `distances_known` errors of pixels are known, and measures
    /// the cost and the error of the settings.
    void judge(Judged& judged, std::size_t distances_known, int& round) {
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
    void set_cost(Trial& trial, const TrialSample& in_penumbrae) {
        const double light_rays =
            calm_share_ * mean(render_pixels(trial.settings, calm_, first_round).light_rays);
        const double elsewhere = light_rays + (1 - share_) * without_light_rays_;
        trial.rays = share_ * in_penumbrae.rays + elsewhere;
        // Outside penumbras, rays to a light take about as long as inside.
        const double of_a_ray =
            in_penumbrae.rays > 0 ? in_penumbrae.seconds / in_penumbrae.rays : seconds_of_a_ray_;
        trial.seconds =
            runner_.picture_seconds(share_ * in_penumbrae.seconds + light_rays * of_a_ray +
                                    (elsewhere - light_rays) * seconds_of_a_ray_);
    }

    /// Settings with about the largest error that still meets the tolerance.
    Judged tuned(double error, int agree) {
        Judged first = judged(to_error(settings_, error, agree));
        const double room = first.trial.error > 0 ? allowed_ / first.trial.error : 10;
        if (1 <= room && (room < 1.25 || has_tried_enough(first.trial))) return first;
        const double before = error;
        error = std::clamp(error * std::clamp(0.95 * room, 0.5, 1.6), least_error(),
                           std::max(1.2 * allowed_, least_error()));
        if (error == before) return first;
        Judged second = judged(to_error(settings_, error, agree));
        return is_better(second, first) ? second : first;
    }

    /// The number of agreeing rays with which the search starts.
    [[nodiscard]] int usual_agree() const {
        return int(std::bit_floor(unsigned(std::clamp(32 / std::sqrt(allowed_), 4., 1024.))));
    }

    /// Settings for penumbras whose rays cost less than trials would, because they have few pixels.
    /// In so few pixels, two that exceed the tolerance may break the promise.
    [[nodiscard]] Trial untried() {
        constexpr int fewest_agree = 48;
        const int agree = std::max(2 * usual_agree(), fewest_agree);
        return judged(to_error(settings_, least_error(), agree), 1).trial;
    }

    /// Searches for settings that meet the tolerance.
    Judged found() {
        constexpr int tries = 12;
        Judged best = tuned(likely_error(), usual_agree());
        for (int i = 0; i < tries && !keeps(best) && !is_finest(best.trial.settings); ++i)
            best = finer(best);
        return best;
    }

    [[nodiscard]] bool is_finest(const RenderSettings& settings) const {
        return settings.shadow_error > 0 && settings.shadow_error <= least_error() &&
               settings.shadow_agree >= reference_.shadow_agree;
    }

    /// A smaller error or a larger number of agreeing rays, whichever reduces the error more for
    /// its cost.
    Judged finer(const Judged& before) {
        const RenderSettings settings = before.trial.settings;
        if (settings.shadow_error == 0)
            return settings.shadow_samples < 4
                       ? judged(with_rays(settings, 2 * settings.shadow_samples))
                       : judged(to_error(settings, likely_error(), 16));
        const double part = std::clamp(0.95 * allowed_ / before.trial.error, 0.5, 0.8);
        const RenderSettings to_less = to_error(
            settings, std::max(part * settings.shadow_error, least_error()), settings.shadow_agree);
        const RenderSettings of_more =
            to_error(settings, settings.shadow_error, settings.shadow_agree * 2);
        if (settings.shadow_agree >= reference_.shadow_agree) return judged(to_less);
        if (settings.shadow_error <= least_error()) return judged(of_more);
        Judged less = judged(to_less);
        Judged more = judged(of_more);
        const auto worth = [&](const Judged& judged) {
            const double price = std::max(judged.trial.rays / before.trial.rays, 1.01);
            return std::log(before.trial.error / judged.trial.error) / std::log(price);
        };
        return worth(less) > worth(more) ? less : more;
    }

    /// The settings, or finer ones, that meet the tolerance with other random rays too, and in the
    /// worst tile.
    Trial confirmed(Judged judged) {
        constexpr int tries = 6;
        constexpr std::size_t fewest = 64;
        for (int i = 0;; ++i) {
            judge(judged, fewest, round_);
            if (i == tries || is_finest(judged.trial.settings) ||
                (keeps(judged) && worst_tile_keeps(judged)))
                return judged.trial;
            judged = finer(judged);
        }
    }

    /// Returns whether the tile with most pixels above the tolerance meets it, judged by all of its
    /// trial pixels.
    bool worst_tile_keeps(const Judged& judged) {
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
        const double most_beyond =
            few_in_a_tile * (double(pixels.size()) + clear * penumbrae_.draws);
        if (double(pixels.size()) <= most_beyond) return true;
        const RenderSettings& settings = judged.trial.settings;
        const TrialSample right = render_pixels(reference_, pixels, ++round_);
        const std::vector<double> off = distances(render_pixels(settings, pixels, ++round_), right);
        const double allowed = allowed_ * reference_bias(settings, reference_);
        return double(std::ranges::count_if(off, [=](double d) { return d > allowed; })) <=
               most_beyond;
    }

    static constexpr double fewest_pixels = 70;  ///< in penumbrae, for trials to pay
    static constexpr int first_round = 500;      ///< of looks that are compared

    TrialRunner& runner_;
    const Trials& trials_;
    double allowed_;
    RenderSettings settings_;
    int round_ = 2;  ///< as many as were looked for penumbrae with
    double rays_spent_ = 0;
    RenderSettings reference_;
    Penumbrae penumbrae_;
    std::vector<Pixel> pixels_;  ///< pixels in penumbras, for trials of settings
    TrialSample right_;          ///< those pixels rendered with the reference settings
    double share_ = 0;           ///< fraction of the picture that they represent
    std::vector<Pixel> calm_;    ///< other pixels that send rays to an area light
    double calm_share_ = 0;
    double without_light_rays_ = 0;  ///< number of other rays of a pixel
    double seconds_of_a_ray_ = 0;    ///< CPU seconds of one of them
};

}  // namespace

Trial keep_tolerance(TrialRunner& runner, const Trials& trials, const RenderSettings& settings) {
    return Sampling(runner, trials, settings).best();
}

QualityLadder measure_ladder(TrialRunner& runner, const Trials& trials,
                             const RenderSettings& settings) {
    const std::vector<Pixel> scattered = runner.spread().pixels();
    const std::vector<Pixel> pixels =
        some_of(scattered, std::max<std::size_t>(1000, scattered.size() / 8));
    const std::vector<RenderSettings> candidates = sampling_candidates(settings);
    const double time = *runner.aim().time;
    QualityLadder ladder;
    TrialSample finest = runner.render_pixels(trials, candidates[0], pixels, 1);
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        const TrialSample before =
            std::exchange(finest, runner.render_pixels(trials, candidates[i], pixels, int(i) + 1));
        ladder.add({.settings = candidates[i - 1],
                    .seconds = runner.picture_seconds(before.seconds),
                    .rays = before.rays,
                    .error = error_but_for_share(few_pixels, distances(before, finest)) /
                             reference_bias(candidates[i - 1], candidates[i])});
        if (ladder.top().seconds > time) break;
        if (runner.no_time_left() && ladder.top().settings.shadow_error > 0) {
            ladder.extend({candidates.begin() + std::ptrdiff_t(i), candidates.end()}, time);
            break;
        }
    }
    return ladder;
}

std::string samples_in_words(const RenderSettings& settings) {
    if (settings.shadow_error == 0)
        return std::to_string(settings.shadow_samples) + " to a light with a size";
    return "until the estimated error of a light is below " + levels(settings.shadow_error) +
           (settings.shadow_agree > 0
                ? ", or " + std::to_string(settings.shadow_agree) + " rays agree"
                : "");
}

}  // namespace rt
