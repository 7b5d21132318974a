#include "common/tuning/choose_samples.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/penumbra_study.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/promise.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace rt {

namespace {

class Sampling {
public:
    using Judged = PenumbraStudy::Judged;

    Sampling(TrialRunner& runner, const Trials& trials, const RenderSettings& settings)
        : allowed_(*runner.aim().tolerance),
          pixels_(runner.pixels()),
          settings_(settings),
          study_(runner, trials, settings, allowed_) {}

    [[nodiscard]] Trial best() {
        if (study_.pixels() > 0 && study_.pixels() < fewest_pixels) return untried();
        for (const int rays : {1, 2, 4}) {
            const Judged few = study_.judged(with_rays(settings_, rays));
            if (keeps(few)) return confirmed(few);
            if (few.trial.error > 4 * allowed_) break;  // more than four times the rays can reduce
        }
        return confirmed(found());
    }

private:
    /// Returns whether better settings would save less than more trials cost.
    [[nodiscard]] bool has_tried_enough(const Trial& best) const {
        return study_.rays_spent() > 0.06 * best.rays * pixels_;
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
        return allowed_ * std::clamp(0.85 - study_.share() / 2, 0.45, 0.7);
    }

    /// Settings with about the largest error that still meets the tolerance.
    Judged tuned(double error, int agree) {
        Judged first = study_.judged(to_error(settings_, error, agree));
        const double room = first.trial.error > 0 ? allowed_ / first.trial.error : 10;
        if (1 <= room && (room < 1.25 || has_tried_enough(first.trial))) return first;
        const double before = error;
        error = std::clamp(error * std::clamp(0.95 * room, 0.5, 1.6), least_error(),
                           std::max(1.2 * allowed_, least_error()));
        if (error == before) return first;
        Judged second = study_.judged(to_error(settings_, error, agree));
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
        return study_.judged(to_error(settings_, least_error(), agree), 1).trial;
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
               settings.shadow_agree >= study_.reference().shadow_agree;
    }

    /// A smaller error or a larger number of agreeing rays, whichever reduces the error more for
    /// its cost.
    Judged finer(const Judged& before) {
        const RenderSettings settings = before.trial.settings;
        if (settings.shadow_error == 0)
            return settings.shadow_samples < 4
                       ? study_.judged(with_rays(settings, 2 * settings.shadow_samples))
                       : study_.judged(to_error(settings, likely_error(), 16));
        const double part = std::clamp(0.95 * allowed_ / before.trial.error, 0.5, 0.8);
        const RenderSettings to_less = to_error(
            settings, std::max(part * settings.shadow_error, least_error()), settings.shadow_agree);
        const RenderSettings of_more =
            to_error(settings, settings.shadow_error, settings.shadow_agree * 2);
        if (settings.shadow_agree >= study_.reference().shadow_agree) return study_.judged(to_less);
        if (settings.shadow_error <= least_error()) return study_.judged(of_more);
        Judged less = study_.judged(to_less);
        Judged more = study_.judged(of_more);
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
        for (int i = 0;; ++i) {
            study_.judge_again(judged);
            if (i == tries || is_finest(judged.trial.settings) ||
                (keeps(judged) && study_.worst_tile_keeps(judged)))
                return judged.trial;
            judged = finer(judged);
        }
    }

    static constexpr double fewest_pixels = 70;  ///< in penumbrae, for trials to pay

    double allowed_;
    double pixels_;  ///< of the picture
    RenderSettings settings_;
    PenumbraStudy study_;
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
