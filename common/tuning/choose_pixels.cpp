#include "common/tuning/choices.hpp"

#include "common/tuning/candidates.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace rt {

namespace {

/// The factor from one error that is tried to the next. Every eighth needs twice as many rays.
const double error_step = std::pow(2, 0.125);

RenderSettings with_pixel_error(RenderSettings settings, double error) {
    settings.pixel_samples = right_pixel_samples;
    settings.pixel_error = error < largest_pixel_error ? two_digits(error) : largest_pixel_error;
    return settings;
}

/// Settings, with the expected cost and error of a picture.
struct Candidate {
    RenderSettings settings;
    PixelStudy::Outcome outcome;
};

/// The search for the cheapest settings that keep the tolerance.
class PixelSearch {
public:
    explicit PixelSearch(PixelStudy& study)
        : allowed_(study.allowed()), settings_(study.settings()), study_(study) {}

    /// The least accurate right colors are compared first, since most of the cost is theirs. More
    /// accurate ones follow as long as rays beside edges may then keep the tolerance.
    [[nodiscard]] Trial best() {
        constexpr double fewer = 0.75;
        double beyond = 1;
        for (double right_error = allowed_ / 2;; right_error /= 2) {
            study_.begin(right_error);
            const double before = std::exchange(beyond, finest(right_error).outcome.beyond);
            if (beyond <= share_ || beyond > fewer * before || right_error < allowed_ / 8) {
                const Candidate most{.settings = study_.with_pixel_samples(right_pixel_samples)};
                return study_.trial(cheaper(best_with(right_error).value_or(most)).settings);
            }
        }
    }

private:
    [[nodiscard]] bool keeps(const Candidate& candidate) const {
        return candidate.outcome.at_most() <= share_ &&
               study_.tiles_keep(candidate.settings, 2 * allowed_);
    }

    /// Settings that stop at an error or at a number of rays, if they are cheaper: the last pixels
    /// to reach the error need most rays.
    [[nodiscard]] Candidate cheaper(Candidate best) const {
        if (best.settings.pixel_samples == 1 || best.outcome.at_most() > share_) return best;
        const double of_best = best.settings.pixel_error;
        double error = of_best > 0 ? of_best : 16 * allowed_;
        for (int most = right_pixel_samples / 2; most >= 8; most /= 2)
            for (;; error /= std::sqrt(std::numbers::sqrt2)) {  // fewer rays need a smaller one
                Candidate capped{.settings = with_pixel_error(settings_, error)};
                capped.settings.pixel_samples = most;
                capped.outcome = study_.outcome(capped.settings);
                if (error < allowed_ / 4 || capped.outcome.rays >= best.outcome.rays) break;
                if (!keeps(capped)) continue;
                best = capped;
                break;
            }
        return best;
    }

    /// The most accurate settings beside edges that can be compared with right colors of that
    /// error.
    [[nodiscard]] Candidate finest(double right_error) const {
        const RenderSettings settings =
            with_pixel_error(settings_, right_error * std::numbers::sqrt2);
        return {.settings = settings, .outcome = study_.outcome(settings)};
    }

    /// Traces trial pixels until more of them would take more rays than they could save.
    [[nodiscard]] std::optional<Candidate> best_with(double right_error) {
        while (true) {
            const std::vector<Candidate> all = candidates(right_error);
            const auto best = std::ranges::find_if(
                all, [&](const Candidate& candidate) { return keeps(candidate); });
            const bool found = best != all.end();
            auto growth = best_growth(std::span(all.begin(), best),
                                      found ? std::optional(best->outcome.rays) : std::nullopt);
            if (!growth && found) growth = cheap_growth(best->outcome);
            if (growth)
                study_.grow(*growth);
            else
                return found ? std::optional(*best) : std::nullopt;
        }
    }

    /// The kind of trial pixels of which more are worth their rays, since one of these settings may
    /// then be certain to keep the tolerance. `rays` are those of the cheapest that does, if any.
    [[nodiscard]] std::optional<std::size_t> best_growth(std::span<const Candidate> cheaper,
                                                         std::optional<double> rays) const {
        constexpr double chance = 0.75;  // what is estimated of them may be wrong
        std::optional<std::size_t> kind;
        double least = 0;
        for (const auto& [settings, outcome] : cheaper) {
            const auto growth = study_.growth(outcome, share_);
            if (!growth) continue;
            const double cost = growth->rays + chance * (outcome.rays - rays.value_or(1e15));
            if (cost < least) {
                least = cost;
                kind = growth->kind;
            }
        }
        return kind;
    }

    /// The kind of trial pixels of which more remove most doubt, as long as all trials are a small
    /// part of the picture's rays: settings that seem not to keep the tolerance may do.
    [[nodiscard]] std::optional<std::size_t> cheap_growth(
        const PixelStudy::Outcome& outcome) const {
        constexpr double small_part = 0.04;
        const auto growth = study_.growth(outcome, (outcome.beyond + outcome.at_most()) / 2);
        const double picture = outcome.rays + study_.center_rays();
        if (!growth || study_.spent() > small_part * picture) return {};
        return growth->kind;
    }

    /// The settings that can be compared with right colors of that error and may keep the
    /// tolerance, the cheapest first.
    [[nodiscard]] std::vector<Candidate> candidates(double right_error) const {
        std::vector<Candidate> all;
        const auto add = [&](const RenderSettings& settings) {
            all.push_back({.settings = settings, .outcome = study_.outcome(settings)});
        };
        add(study_.with_pixel_samples(1));
        constexpr double far_beyond = 3 * few_pixels;
        for (double error = right_error * std::numbers::sqrt2;
             error < std::min(64 * allowed_, largest_pixel_error); error *= error_step) {
            add(with_pixel_error(settings_, error));
            if (all.back().outcome.beyond > far_beyond) break;  // a larger error has more
        }
        if (right_error < allowed_)
            for (int count = 8; count <= right_pixel_samples; count *= 2) {
                add(study_.with_pixel_samples(count / 2));
                add(study_.with_pixel_samples(count / 4 * 3));
                if (count == right_pixel_samples) add(study_.with_pixel_samples(count));
            }
        std::ranges::stable_sort(all, {},
                                 [](const Candidate& candidate) { return candidate.outcome.rays; });
        return all;
    }

    double allowed_;
    double share_ = few_pixels;
    RenderSettings settings_;
    PixelStudy& study_;
};

/// Estimates which share of the pixels that send rays to a light with a size is in a penumbra: the
/// same settings with other rays give another color. The share is rather too large than too small,
/// and infinite if no pixel sends any.
double share_in_penumbrae(TrialRunner& runner, const Trials& trials,
                          const RenderSettings& settings) {
    constexpr std::size_t enough = 512;
    const std::vector<Pixel> pixels = some_of(runner.spread().pixels(), enough);
    const TrialSample one = runner.render_pixels(trials, settings, pixels, 1);
    const std::vector<double> apart =
        distances(one, runner.render_pixels(trials, settings, pixels, 2));
    int sending = 0;
    int different = 1;  // one more, which chance may have spared
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (one.light_rays[i] == 0) continue;
        ++sending;
        if (apart[i] > runner.limit() / 8) ++different;
    }
    return double(different) / double(sending);
}

}  // namespace

RenderSettings with_few_shadow_rays(TrialRunner& runner, const Trials& trials,
                                    const SceneTraits& traits, const RenderSettings& settings) {
    if (!traits.sized_lights || runner.aim().given.shadow_samples) return settings;
    constexpr std::size_t few_shapes = 24;
    const RenderSettings many = with_rays(settings, traits.shapes <= few_shapes ? 32 : 16);
    if (runner.aim().time) {
        constexpr std::size_t enough = 128;
        const std::vector<Pixel> pixels = some_of(runner.spread().pixels(), enough);
        const auto is_long = [&](const RenderSettings& lit, double part) {
            const double seconds = runner.render_pixels(trials, lit, pixels, 0).seconds;
            return runner.picture_seconds(seconds) > part * *runner.aim().time;
        };
        const RenderSettings few = with_rays(settings, 4);
        if (is_long(many, 0.25)) return is_long(few, 0.75) ? with_rays(settings, 1) : few;
    }
    const RenderSettings fewer = with_rays(settings, 16);
    const double share = share_in_penumbrae(runner, trials, fewer);
    if (share > 1. / 16) return many;
    return share > 1. / 64 ? fewer : with_rays(settings, 8);
}

Trial keep_tolerance_of_pixels(PixelStudy& study) {
    return PixelSearch(study).best();
}

QualityLadder measure_pixel_ladder(const TrialRunner& runner, PixelStudy& study) {
    constexpr double finest = 0.5;
    const double time = *runner.aim().time;
    study.begin(finest / std::numbers::sqrt2);
    const RenderSettings most = study.with_pixel_samples(right_pixel_samples);
    while (runner.seconds_since_start() < time / 20) {
        const auto growth = study.growth(study.outcome(most), few_pixels);
        if (!growth) break;
        study.grow(growth->kind);
    }
    QualityLadder ladder;
    constexpr double almost = 0.99;  // the steps are rounded
    for (double error = largest_pixel_error; error > almost * finest;
         error = std::min(error, 32 * std::sqrt(2)) / std::sqrt(2)) {
        ladder.add(study.trial(with_pixel_error(study.settings(), error)));
        if (ladder.top().seconds > time) return ladder;
    }
    // Estimated, not with confidence: a doubt would fill the time with rays that nobody sees.
    constexpr double seen = 1;
    if (study.outcome(ladder.top().settings, seen).beyond <= few_pixels) return ladder;
    // There is time for more than adaptive sampling can use: it does not find every edge.
    QualityLadder whole;
    for (int count = 64; count <= right_pixel_samples; count *= 2) {
        whole.add(study.trial(study.with_pixel_samples(count)));
        if (whole.top().seconds > time) break;
    }
    const bool fits = whole.within_time(0).seconds <= time;  // the cheapest
    return fits && whole.within_time(time).error < ladder.top().error ? whole : ladder;
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
