#include "common/tuning/auto_settings.hpp"

#include "common/tuning/choices.hpp"
#include "common/tuning/pixel_errors.hpp"
#include "common/tuning/trial_runner.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <utility>

namespace rt {

namespace {

class Tuner {
public:
    Tuner(Trials& trials, const Aim& aim, Clock::time_point start, const std::atomic<bool>& stop)
        : trials_(&trials),
          aim_(aim),
          start_(start),
          runner_(trials.resolution(), aim, stop),
          traits_(trials.traits()),
          settings_(aim.settings) {}

    AutoSettings choose(const OpenFloat& open_float) {
        depth();
        precision(open_float);
        if (aim_.given.pixel_samples)
            samples();
        else
            pixels();
        report();
        return std::move(choice_);
    }

private:
    void depth() {
        if (aim_.given.depth) return say("depth", std::to_string(settings_.depth) + ", as given");
        const double mirror = traits_.strongest_mirror;
        if (mirror == 0) return say("depth", "none: there is no mirror");
        settings_.depth = sufficient_depth(mirror, runner_.limit());
        const std::string why =
            ": a mirror reflects up to " + number(100 * mirror) + " % of the light";
        constexpr int few = 4;  // hardly cost more than what is seen
        if (!aim_.time && settings_.depth > few) {
            const auto [seen, pixels] =
                seen_depth(runner_, *trials_, with_one_shadow_ray(settings_, aim_));
            const std::string deepest = std::to_string(std::exchange(settings_.depth, seen));
            return say("depth", std::to_string(seen) + why + ", but " + deepest +
                                    " reflections change none of " + std::to_string(pixels) +
                                    " pixels");
        }
        say("depth", std::to_string(settings_.depth) + why);
        if (!aim_.time) return;
        const int fits = depth_within_time(runner_, *trials_, with_one_shadow_ray(settings_, aim_));
        if (fits < settings_.depth) say("", "but " + std::to_string(fits) + " to keep the time");
        settings_.depth = fits;
    }

    void samples() {
        const bool sampled = traits_.sized_lights && !aim_.given.shadow_samples;
        choice_.expected.settings = settings_;
        if (sampled && aim_.time)
            samples_for_time();
        else if (sampled)
            choice_.expected = keep_tolerance(runner_, *trials_, settings_);
        say("shadow samples",
            sampled ? samples_in_words(choice_.expected.settings) : why_no_samples());
        if (!choice_.pace) measure_cost(choice_.expected);
    }

    /// Chooses the rays through pixels, and those to lights with them.
    void pixels() {
        constexpr int many = 128;  // rays to a light, so many that few pixels need more
        const bool soft = traits_.sized_lights && !aim_.given.shadow_samples;
        RenderSettings lit = with_few_shadow_rays(runner_, *trials_, traits_, settings_);
        for (bool again = true; again; lit.shadow_samples *= 4) {
            PixelStudy study(runner_, *trials_, lit, allowed(), soft);
            if (aim_.time)
                pixels_for_time(study);
            else
                choice_.expected = keep_tolerance_of_pixels(study);
            details_ = study.details();
            again = soft && !aim_.time && !is_promised() && lit.shadow_samples < many;
        }
        const RenderSettings& settings = choice_.expected.settings;
        say("shadow samples", soft ? samples_in_words(settings) : why_no_samples());
        say("pixel samples", pixels_in_words(settings));
        if (!details_.empty()) say("fine shapes", details_);
    }

    [[nodiscard]] double allowed() const { return aim_.tolerance.value_or(1); }
    [[nodiscard]] bool is_promised() const { return choice_.expected.at_most <= few_pixels; }

    void pixels_for_time(PixelStudy& study) {
        QualityLadder ladder = measure_pixel_ladder(runner_, study);
        if (aim_.tolerance) ladder.end_at(*aim_.tolerance);
        choice_.expected = ladder.within_time(*aim_.time);
        ladder.shorten(study.center_seconds());
        set_pace(ladder);
    }

    void measure_cost(Trial& trial) {
        const std::vector<Pixel> all = runner_.spread().pixels();
        const std::vector<Pixel> some = some_of(all, std::max<std::size_t>(all.size() / 32, 128));
        const auto [few_rays, times] = with_few_rays(trial.settings);
        const TrialSample sample = runner_.render_pixels(*trials_, few_rays, some, 1);
        trial.seconds = runner_.picture_seconds(times * sample.seconds);
        trial.rays = times * sample.rays;
    }

    [[nodiscard]] std::string why_no_samples() const {
        return aim_.given.shadow_samples ? "as given" : "one: no light has a size";
    }

    void samples_for_time() {
        QualityLadder ladder = measure_ladder(runner_, *trials_, settings_);
        if (aim_.tolerance) ladder.end_at(*aim_.tolerance);
        choice_.expected = ladder.within_time(*aim_.time);
        set_pace(ladder);
    }

    void set_pace(const QualityLadder& ladder) {
        RenderSettings& settings = choice_.expected.settings;
        if (settings.shadow_error > 0) settings.shadow_error = two_digits(settings.shadow_error);
        if (settings.pixel_error > 0 && settings.pixel_error < largest_pixel_error)
            settings.pixel_error = two_digits(settings.pixel_error);
        const auto time = std::chrono::duration<double>(*aim_.time);
        choice_.pace = std::make_unique<TimeBudget>(
            ladder, runner_.size().height,
            start_ + std::chrono::duration_cast<Clock::duration>(time), runner_.limit());
    }

    void precision(const OpenFloat& open_float) {
        const PrecisionChoice precision =
            choose_precision(runner_, *trials_, traits_, open_float, settings_);
        if (precision.in_float != nullptr) trials_ = precision.in_float;
        choice_.in_float = precision.in_float != nullptr;
        say("precision", precision.why);
    }

    void report() {
        const double seconds = choice_.expected.seconds;
        const bool too_long = aim_.time && seconds > 1.1 * *aim_.time;
        say("expected", number(seconds) + " s" + expected_error() +
                            (too_long ? ": no setting is cheaper" : ""));
        // The picture keeps the rays through the centers, and their time is counted as its own.
        const bool kept = begins_with_centers(choice_.expected.settings);
        const double traced =
            runner_.rays_traced() + (kept ? 0 : runner_.center_rays() * runner_.pixels());
        const double spent = runner_.seconds_since_start() - (kept ? runner_.center_seconds() : 0);
        const double rays = choice_.expected.rays * runner_.pixels();
        // With a time, the rays of the picture are not known before.
        const std::string part =
            rays > 0 ? number(100 * traced / rays) + " % of the picture's rays, " : "";
        say("trials", std::to_string(runner_.pixels_drawn()) + " pixels, " + part + number(spent) +
                          " s by the clock");
    }

    /// The expected error, the picture from which it is measured, and what is not promised.
    [[nodiscard]] std::string expected_error() const {
        const double error = std::max(choice_.expected.error, runner_.limit());
        if (aim_.given.pixel_samples) return error_of_light(error);
        const std::string right = " the mean of endlessly many rays";
        if (choice_.pace)
            return error < largest_pixel_error ? ", and 99 of 100 pixels within " + levels(error) +
                                                     " of" + right + ", with 95 % confidence"
                                               : ", and an error that there is no time to measure";
        const auto percent = [](double share) { return number(100 * share) + " %"; };
        return "; off from" + right + " by more than " + levels(allowed()) + ": " +
               percent(choice_.expected.beyond) + " of the pixels, with 95 % confidence at most " +
               percent(choice_.expected.at_most) +
               (is_promised() ? "" : ". The tolerance is not promised");
    }

    /// The same where the number of rays through a pixel is given.
    [[nodiscard]] std::string error_of_light(double error) const {
        const std::string samples = std::to_string(aim_.settings.pixel_samples);
        const std::string missed = ". What " + samples + (samples == "1" ? " ray" : " rays") +
                                   " through a pixel cannot show is not promised";
        const bool sampled = traits_.sized_lights && !aim_.given.shadow_samples;
        if (traits_.sized_lights && !sampled) return missed + ", nor is the error of shadows";
        std::string text = ", and 99 of 100 pixels within " + levels(error);
        if (!sampled) return text + " of double precision" + missed;
        if (aim_.tolerance && !aim_.time) text += ", 9 of 10 in penumbrae,";
        return text + " of endlessly many rays to each light, with 95 % confidence" + missed;
    }

    void say(const std::string& what, const std::string& why) {
        choice_.reasons.push_back(line(what, why));
    }

    Trials* trials_;  ///< in the precision chosen
    const Aim& aim_;
    Clock::time_point start_;
    TrialRunner runner_;
    SceneTraits traits_;
    RenderSettings settings_;
    AutoSettings choice_;
    std::string details_;  ///< of shapes narrower than a pixel
};

}  // namespace

std::optional<AutoSettings> choose(Trials& trials, const OpenFloat& open_float, const Aim& aim,
                                   Clock::time_point start, const std::atomic<bool>& stop) {
    try {
        return Tuner(trials, aim, start, stop).choose(open_float);
    } catch (const Stopped&) {
        return std::nullopt;
    }
}

}  // namespace rt
