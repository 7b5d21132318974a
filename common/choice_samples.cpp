#include "common/choice_samples.hpp"

#include "common/choice_words.hpp"
#include "common/penumbrae.hpp"
#include "common/sampling_looks.hpp"
#include "common/shot_errors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>

namespace rt {

namespace {

/// Settings measured on the doubtful pixels.
struct Judged {
    Trial trial;
    std::vector<double> off;  ///< error of each pixel, for each sample in turn
};

class Sampling {
public:
    Sampling(TrialRunner& runner, const Trials& trials, const Look& look)
        : runner_(runner),
          trials_(trials),
          allowed_(*runner.aim().tolerance),
          look_(look),
          reference_(reference_look(look, allowed_)),
          penumbrae_(find_penumbrae(runner, trials, look)),
          pixels_(some_of(penumbrae_.doubtful, pixels_to_try())),
          asked_(some_of(penumbrae_.asked, 64)),
          right_(shot(reference_, pixels_, ++round_)) {
        const Shot one = shot(with_rays(look, 1), pixels_, ++round_);
        for (const double off : distances(one, right_)) in_penumbra_.push_back(off > allowed_);
        const Shot clear = shot(with_rays(look, 1), some_of(penumbrae_.clear, 128), ++round_);
        without_light_rays_ = clear.rays - mean(clear.light_rays);
        seconds_of_a_ray_ = clear.rays > 0 ? clear.seconds / clear.rays : 0;
    }

    [[nodiscard]] Trial best() {
        for (const int rays : {1, 2, 4}) {
            const Judged few = judged(with_rays(look_, rays));
            if (keeps(few)) return confirmed(few);
            if (few.trial.error > 4 * allowed_) break;  // more than four times the rays can reduce
        }
        Judged best = found();
        // A smaller or larger number of agreeing rays may need fewer rays in total.
        const auto better_with = [&](int agree) {
            if (agree < 2 || has_tried_enough(best.trial)) return false;
            Judged other = tuned(best.trial.look.shadow_error, agree);
            if (!is_better(other, best)) return false;
            best = std::move(other);
            return true;
        };
        if (better_with(best.trial.look.shadow_agree / 2))
            while (better_with(best.trial.look.shadow_agree / 2)) {
            }
        else
            while (better_with(best.trial.look.shadow_agree * 2)) {
            }
        return confirmed(best);
    }

private:
    [[nodiscard]] double all_pixels() const {
        return double(runner_.size().width) * double(runner_.size().height);
    }

    [[nodiscard]] std::size_t pixels_to_try() const {
        return std::size_t(std::clamp(penumbrae_.share * all_pixels() / 64, 192., 1000.));
    }

    Shot shot(const Look& look, const std::vector<Pixel>& pixels, int round) {
        Shot shot = runner_.shot(trials_, look, pixels, round);
        rays_spent_ += shot.rays * double(pixels.size());
        return shot;
    }

    /// Returns whether better settings would save less than more trials cost.
    [[nodiscard]] bool has_tried_enough(const Trial& best) const {
        return rays_spent_ > 0.06 * best.rays * all_pixels();
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

    /// The error at which sampling can stop, if share_error (stage 11) estimates it correctly. It
    /// is smaller if more of the picture is in a penumbra, because then a smaller fraction of those
    /// pixels may exceed the tolerance.
    [[nodiscard]] double likely_error() const {
        return allowed_ * std::clamp(0.85 - penumbrae_.share / 2, 0.45, 0.7);
    }

    Judged judged(Look look) {
        if (look.shadow_error > 0) look.shadow_error = two_digits(look.shadow_error);
        Judged result{.trial = {.look = look}};
        judge_again(result, first_round);
        return result;
    }

    /// Adds one more sample to the measured cost and error of the settings.
    void judge_again(Judged& judged, int round) {
        const Look& look = judged.trial.look;
        const Shot next = shot(look, pixels_, round);
        for (const double off : distances(next, right_))
            judged.off.push_back(off / excess(look, reference_));
        std::vector<double> in_penumbra;
        for (std::size_t i = 0; i < judged.off.size(); ++i)
            if (in_penumbra_[i % pixels_.size()]) in_penumbra.push_back(judged.off[i]);
        judged.trial.error = error_but_for_share(few_in_penumbrae, in_penumbra);
        if (penumbrae_.share > few_pixels)
            judged.trial.error = std::max(
                judged.trial.error, error_but_for_share(few_pixels / penumbrae_.share, judged.off));
        tell_costs(judged.trial, next);
    }

    /// Computes the cost of the settings from the doubtful pixels and the others.
    void tell_costs(Trial& trial, const Shot& doubtful) {
        const Shot asked = shot(trial.look, asked_, first_round);
        const double clear = double(penumbrae_.clear.size());
        const double light_rays =
            clear > 0 ? mean(asked.light_rays) * double(penumbrae_.asked.size()) / clear : 0;
        const double share = penumbrae_.share;
        trial.rays = share * doubtful.rays + (1 - share) * (light_rays + without_light_rays_);
        // Outside penumbras, rays to a light take about as long as inside.
        const double of_a_ray =
            doubtful.rays > 0 ? doubtful.seconds / doubtful.rays : seconds_of_a_ray_;
        const double elsewhere = light_rays * of_a_ray + without_light_rays_ * seconds_of_a_ray_;
        trial.seconds = runner_.picture_seconds(share * doubtful.seconds + (1 - share) * elsewhere);
    }

    /// Settings with about the largest error that still meets the tolerance.
    Judged tuned(double error, int agree) {
        Judged first = judged(to_error(look_, error, agree));
        const double room = first.trial.error > 0 ? allowed_ / first.trial.error : 10;
        if (1 <= room && (room < 1.25 || has_tried_enough(first.trial))) return first;
        error =
            std::clamp(error * std::clamp(0.95 * room, 0.5, 1.6), 0.3 * allowed_, 1.2 * allowed_);
        Judged second = judged(to_error(look_, error, agree));
        return is_better(second, first) ? second : first;
    }

    /// Searches for settings that meet the tolerance.
    Judged found() {
        constexpr int tries = 12;
        const auto usual = unsigned(std::clamp(32 / std::sqrt(allowed_), 4., 1024.));
        Judged best = tuned(likely_error(), int(std::bit_floor(usual)));
        for (int i = 0; i < tries && !keeps(best); ++i) best = finer(best);
        return best;
    }

    /// A smaller error or a larger number of agreeing rays, whichever reduces the error more for
    /// its cost.
    Judged finer(const Judged& before) {
        const Look look = before.trial.look;
        if (look.shadow_error == 0)
            return look.shadow_samples < 4 ? judged(with_rays(look, 2 * look.shadow_samples))
                                           : judged(to_error(look, likely_error(), 16));
        const double part = std::clamp(0.95 * allowed_ / before.trial.error, 0.5, 0.8);
        Judged to_less = judged(to_error(look, part * look.shadow_error, look.shadow_agree));
        if (look.shadow_agree >= reference_.shadow_agree) return to_less;
        Judged of_more = judged(to_error(look, look.shadow_error, 2 * look.shadow_agree));
        const auto worth = [&](const Judged& judged) {
            const double price = std::max(judged.trial.rays / before.trial.rays, 1.01);
            return std::log(before.trial.error / judged.trial.error) / std::log(price);
        };
        return worth(to_less) > worth(of_more) ? to_less : of_more;
    }

    /// The settings, or finer ones, that meet the tolerance with other random rays too, and in the
    /// worst tile.
    Trial confirmed(Judged judged) {
        constexpr int tries = 6;
        for (int i = 0;; ++i) {
            judge_again(judged, ++round_);
            if (i == tries || (keeps(judged) && worst_tile_keeps(judged))) return judged.trial;
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
        const Look& look = judged.trial.look;
        const Shot right = shot(reference_, pixels, ++round_);
        std::vector<double> off = distances(shot(look, pixels, ++round_), right);
        const double allowed = allowed_ * excess(look, reference_);
        const auto seen = double(std::ranges::count_if(off, [=](double d) { return d > allowed; }));
        const auto clear = double(std::ranges::count_if(penumbrae_.clear, is_there));
        return seen <= few_in_a_tile * (double(pixels.size()) + clear * penumbrae_.draws);
    }

    /// All settings are compared with the same rays.
    static constexpr int first_round = 100;

    TrialRunner& runner_;
    const Trials& trials_;
    double allowed_;
    Look look_;
    int round_ = first_round;
    double rays_spent_ = 0;
    Look reference_;
    Penumbrae penumbrae_;
    std::vector<Pixel> pixels_;  ///< doubtful pixels, for trials of settings
    std::vector<Pixel> asked_;   ///< other pixels, for the cost of rays there
    Shot right_;                 ///< the pixels rendered with the reference settings
    std::vector<bool> in_penumbra_;
    double without_light_rays_ = 0;  ///< number of other rays of a pixel
    double seconds_of_a_ray_ = 0;    ///< CPU seconds of one of them
};

}  // namespace

Trial keep_tolerance(TrialRunner& runner, const Trials& trials, const Look& look) {
    return Sampling(runner, trials, look).best();
}

Ladder climb(TrialRunner& runner, const Trials& trials, const Look& look) {
    const std::vector<Pixel> scattered = runner.spread().pixels();
    const std::vector<Pixel> pixels =
        some_of(scattered, std::max<std::size_t>(1000, scattered.size() / 8));
    const std::vector<Look> looks = sampling_looks(look);
    const double time = *runner.aim().time;
    Ladder ladder;
    Shot finest = runner.shot(trials, looks[0], pixels, 1);
    for (std::size_t i = 1; i < looks.size(); ++i) {
        const Shot before =
            std::exchange(finest, runner.shot(trials, looks[i], pixels, int(i) + 1));
        ladder.add({.look = looks[i - 1],
                    .seconds = runner.picture_seconds(before.seconds),
                    .rays = before.rays,
                    .error = error_but_for_share(few_pixels, distances(before, finest)) /
                             excess(looks[i - 1], looks[i])});
        if (ladder.top().seconds > time) break;
        if (runner.no_time_left() && ladder.top().look.shadow_error > 0) {
            ladder.extend({looks.begin() + std::ptrdiff_t(i), looks.end()}, time);
            break;
        }
    }
    return ladder;
}

std::string samples_in_words(const Look& look) {
    if (look.shadow_error == 0)
        return std::to_string(look.shadow_samples) + " to a light with a size";
    return "until the estimated error of a light is below " + steps(look.shadow_error) +
           (look.shadow_agree > 0 ? ", or " + std::to_string(look.shadow_agree) + " rays agree"
                                  : "");
}

}  // namespace rt
