#include "common/choice.hpp"

#include "common/sampling_looks.hpp"
#include "common/shot_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <utility>

namespace rt {

namespace {

constexpr int endless = 64;  ///< a depth: what is left is seen by no more than half a step

/// Of longer lists nobody needs to try whether a hierarchy pays.
constexpr std::size_t longest_list = 64;
constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// u of float.
constexpr double float_roundoff = std::numeric_limits<float>::epsilon() / 2;

/// Half a step is what rounding to the picture's colors takes.
constexpr double unseen = 0.5;

/// A gain that is more than the clock's noise.
constexpr double gain = 0.95;

/// What a rounding of the precision may do to a color, in 8-bit steps. A point on a shape is off by
/// up to 8 u of its coordinates (docs/stability.md), the normal there by that over the shape's
/// size, and a highlight by so many times that as its exponent says.
double rounding_error(const Demands& demands, double unit_roundoff) {
    if (demands.feature == 0) return 0;
    return 255 * 8 * unit_roundoff * demands.extent / demands.feature * demands.shininess;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value >= 99.5 ? "%.0f" : "%.2g", value);
    return text;
}

/// A number that is told whole, and no larger than the value, which is positive.
double two_digits(double value) {
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    return std::stod(number(digit * std::floor(value / digit)));
}

std::string percent(double share) {
    return number(100 * share) + " %";
}

std::string steps(double value) {
    return number(value) + (value == 1 ? " step" : " steps");
}

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Looks that were not tried, up to those that take too long. Next to each other their errors are
/// as √2 to 1, which takes 2^(2/3) times the rays.
void extend(Ladder& ladder, const std::vector<Look>& looks, double seconds) {
    const double without_rays = ladder.within_time(0).seconds;
    for (const Look& look : looks) {
        const Trial top = ladder.top();
        if (top.seconds > seconds) return;
        const double rays = (top.seconds - without_rays) * std::exp2(2.0 / 3);
        ladder.add(
            {.look = look, .seconds = without_rays + rays, .error = top.error / std::sqrt(2)});
    }
}

/// Thrown between trials.
struct Stopped {};

class Chooser {
public:
    Chooser(Trials& trials, const Aim& aim, Clock::time_point start, const std::atomic<bool>& stop)
        : trials_(trials),
          aim_(aim),
          stop_(stop),
          start_(start),
          read_(Clock::now()),
          demands_(trials.demands()),
          size_(trials.resolution()),
          pixels_(std::min(all_pixels(), std::max<std::size_t>(1000, all_pixels() / 128))),
          hierarchy_from_(demands_.hierarchy_from),
          exceptions_left_(exceptions(2 * pixels_)),
          look_(aim.look) {}

    void choose_hierarchy();
    void choose_depth();
    void choose_samples();
    void choose_precision(const OpenFloat& open_float);
    [[nodiscard]] Choice done();

private:
    [[nodiscard]] std::size_t all_pixels() const {
        return std::size_t(size_.width) * std::size_t(size_.height);
    }

    /// What an error may be before it counts.
    [[nodiscard]] double limit() const { return aim_.tolerance.value_or(unseen); }

    /// Of the whole picture, on all threads.
    [[nodiscard]] double seconds(const Shot& shot) const {
        return shot.seconds * double(all_pixels()) / aim_.threads;
    }

    [[nodiscard]] Shot shot(const Trials& trials, const Look& look, std::size_t pixels,
                            int round) const {
        Shot shot = trials.shot(
            look, {.pixels = pixels, .round = round, .threads = aim_.threads, .stop = &stop_});
        if (stop_) throw Stopped();
        return shot;
    }

    [[nodiscard]] Shot shot(const Look& look, int round) const {
        return shot(trials_, look, pixels_, round);
    }

    /// The look, with one shadow ray: where more would not matter.
    [[nodiscard]] Look at_depth(int depth) const {
        Look look = look_;
        look.depth = depth;
        if (!aim_.given.shadow_samples) look.shadow_samples = 1;
        return look;
    }

    /// Which of two trials, each made ready, takes how long for a pixel: the least of a few tries
    /// in turn.
    template <class First, class Second>
    [[nodiscard]] std::pair<double, double> in_turn(const Look& look, First first,
                                                    Second second) const;

    /// Trials may take a tenth of the time.
    [[nodiscard]] bool no_time_to_try() const {
        return aim_.time && since(read_) > *aim_.time / 10;
    }

    void fit_depth_into_time();
    [[nodiscard]] Ladder climb() const;
    [[nodiscard]] Trial best_around(const Look& found);
    void keep_tolerance();
    [[nodiscard]] std::string expected_error() const;

    void say(const std::string& what, const std::string& why) {
        constexpr std::size_t width = sizeof "shadow samples" + 1;
        choice_.reasons.push_back("  " + what + std::string(width - what.size(), ' ') + why);
    }

    Trials& trials_;
    const Aim& aim_;
    const std::atomic<bool>& stop_;
    Clock::time_point start_;
    Clock::time_point read_;
    Demands demands_;
    Resolution size_;
    std::size_t pixels_;
    std::size_t hierarchy_from_;
    double exceptions_left_;
    Look look_;
    Choice choice_;
    int round_ = 100;  ///< of a shot: the first ones are the climb's
};

template <class First, class Second>
std::pair<double, double> Chooser::in_turn(const Look& look, First first, Second second) const {
    const auto seconds = [&](const Trials& trials) {
        return shot(trials, look, (pixels_ + 7) / 8, 0).seconds;
    };
    std::pair least = {infinite, infinite};
    for (int i = 0; i < 3; ++i) {
        least.first = std::min(least.first, seconds(first()));
        least.second = std::min(least.second, seconds(second()));
    }
    return least;
}

void Chooser::choose_hierarchy() {
    const std::size_t count = demands_.most_alike;
    if (count < 2) return say("hierarchy", "none: no two shapes are of a kind");
    if (count > longest_list)
        return say("hierarchy", "yes: " + std::to_string(count) + " of a kind are too many to ask");
    const bool is_usual = count >= demands_.hierarchy_from;
    const auto arranged = [this](std::size_t pays_from) -> const Trials& {
        trials_.arrange(pays_from);
        return trials_;
    };
    const std::size_t from = is_usual ? demands_.hierarchy_from : 2;
    const auto [list, hierarchy] = in_turn(
        at_depth(look_.depth), [&]() -> const Trials& { return arranged(never); },
        [&]() -> const Trials& { return arranged(from); });
    const bool pays = is_usual ? gain * hierarchy < list : hierarchy < gain * list;
    hierarchy_from_ = pays ? from : never;
    trials_.arrange(hierarchy_from_);
    say("hierarchy", std::string(pays ? "yes" : "none") + ": for up to " + std::to_string(count) +
                         " of a kind, with" + (pays ? "out" : "") + " one it takes " +
                         number(pays ? list / hierarchy : hierarchy / list) + " times as long");
}

void Chooser::choose_depth() {
    if (aim_.given.depth) return say("depth", std::to_string(look_.depth) + ", as given");
    if (!demands_.mirrors) return say("depth", "none: nothing is a mirror");
    constexpr std::array depths = {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, endless};
    const Shot whole = shot(at_depth(endless), 0);
    std::array<double, depths.size()> cut_off{};  // pixels that are off by more than the limit
    const auto too_shallow = [&](const int& depth) {
        double& share = cut_off[std::size_t(&depth - depths.data())];
        share = depth == endless
                    ? 0
                    : share_beyond(limit(), distances(shot(at_depth(depth), 0), whole));
        return share > exceptions_left_ / (demands_.sized_lights ? 8 : 2);
    };
    const auto least =
        std::size_t(std::ranges::partition_point(depths, too_shallow) - depths.begin());
    look_.depth = depths[least];
    exceptions_left_ -= cut_off[least];
    say("depth", std::to_string(look_.depth) +
                     (least == 0 ? ": no reflection shows"
                                 : ": with " + std::to_string(depths[least - 1]) + ", " +
                                       percent(cut_off[least - 1]) +
                                       " of the pixels are off by more than " + steps(limit())));
}

void Chooser::fit_depth_into_time() {
    if (!aim_.time || aim_.given.depth || !demands_.mirrors) return;
    const int wanted = look_.depth;
    while (look_.depth > 0 && seconds(shot(at_depth(look_.depth), 0)) > *aim_.time)
        look_.depth /= 2;
    if (look_.depth < wanted) say("", "but " + std::to_string(look_.depth) + " for the time");
}

/// Lights with a size: cheap looks first, until one is as good as asked for, or takes too long.
Ladder Chooser::climb() const {
    // For a tolerance what is found is tried again, on more.
    const std::size_t pixels = aim_.tolerance ? (pixels_ + 3) / 4 : pixels_;
    const std::vector<Look> looks = sampling_looks(look_);
    Ladder ladder;
    Shot finest = shot(trials_, looks[0], pixels, 1);
    for (std::size_t i = 1; i < looks.size(); ++i) {
        const Shot before = std::exchange(finest, shot(trials_, looks[i], pixels, int(i) + 1));
        const double off = error_but_for(exceptions_left_, distances(before, finest)) /
                           excess(looks[i - 1], looks[i]);
        ladder.add({.look = looks[i - 1], .seconds = seconds(before), .error = off});
        if (aim_.tolerance && off <= *aim_.tolerance) break;
        if (aim_.time && seconds(before) > *aim_.time) break;
        if (no_time_to_try() && ladder.top().look.shadow_error > 0) {
            extend(ladder, {looks.begin() + std::ptrdiff_t(i), looks.end()}, *aim_.time);
            break;
        }
    }
    return ladder;
}

/// The cheapest look about as good as one found that keeps the tolerance, or the best.
Trial Chooser::best_around(const Look& found) {
    const double allowed = *aim_.tolerance;
    const Look finer = finer_than(found);
    const Shot finest = shot(finer, ++round_);
    Trial best = {.seconds = infinite, .error = infinite};
    const auto consider = [&](const Look& look) {
        // The same pixels again are nearly as good as others, and spare a finer shot of these.
        const std::array shots = {shot(look, ++round_), shot(look, ++round_)};
        std::vector<double> both = distances(shots[0], finest);
        std::ranges::copy(distances(shots[1], finest), std::back_inserter(both));
        const double off = error_but_for(exceptions_left_, both) / excess(look, finer);
        const Trial trial{
            .look = look, .seconds = (seconds(shots[0]) + seconds(shots[1])) / 2, .error = off};
        const bool is_cheaper = best.error > allowed || trial.seconds < best.seconds;
        if (off <= allowed ? is_cheaper : off < best.error) best = trial;
        return trial;
    };
    Ladder ladder;
    for (const Look& look : looks_around(found)) {
        ladder.add(consider(look));
        if (ladder.top().error <= allowed) break;
    }
    if (best.look.shadow_error == 0 || best.error > allowed) return best;
    (void)consider(ladder.within_error(allowed).look);
    // Where many must agree, the others are sampled too coarsely.
    constexpr int many = 40;
    for (bool pays = best.look.shadow_agree == 0 || best.look.shadow_agree > many; pays;) {
        const double before = best.seconds;
        (void)consider(fewer_agree(best.look));
        pays = best.seconds < before;
    }
    const Look kept = best.look;
    const double room = std::min(allowed / best.error, 1 / better_sampled);
    for (const double part : {3 / 3., 2 / 3., 1 / 3.}) {
        Look look = kept;
        look.shadow_error *= std::pow(room, part);
        if (consider(look).error <= allowed) break;
    }
    return best;
}

/// The few pixels of the climb may have told too little.
void Chooser::keep_tolerance() {
    constexpr int most_tries = 4;
    Look look = choice_.expected.look;
    for (int i = 0; i < most_tries && !no_time_to_try(); ++i, look = finer_than(look)) {
        choice_.expected = best_around(look);
        if (choice_.expected.error <= *aim_.tolerance) return;
    }
}

void Chooser::choose_samples() {
    fit_depth_into_time();
    if (aim_.given.shadow_samples || !demands_.sized_lights) {
        choice_.expected = {.look = look_, .seconds = seconds(shot(look_, 1))};
        return say("shadow samples",
                   aim_.given.shadow_samples ? "as given" : "one: no light has a size");
    }
    Ladder ladder = climb();
    choice_.expected = aim_.tolerance ? ladder.within_error(*aim_.tolerance) : ladder.top();
    if (aim_.tolerance && ladder.top().error <= *aim_.tolerance) {
        keep_tolerance();
        ladder.end_with(choice_.expected);
    }
    if (aim_.time) {
        if (choice_.expected.seconds > *aim_.time)
            choice_.expected = ladder.within_time(*aim_.time);
        const auto time = std::chrono::duration<double>(*aim_.time);
        choice_.pace = std::make_unique<Pace>(
            ladder, size_.height, start_ + std::chrono::duration_cast<Clock::duration>(time));
    }
    Look& look = choice_.expected.look;
    if (look.shadow_error > 0) look.shadow_error = two_digits(look.shadow_error);
    say("shadow samples",
        look.shadow_error > 0
            ? "until a light is estimated to be off by less than " + steps(look.shadow_error) +
                  (look.shadow_agree > 0
                       ? ", or " + std::to_string(look.shadow_agree) + " rays agree"
                       : "")
            : std::to_string(look.shadow_samples) + " to a light with a size");
}

void Chooser::choose_precision(const OpenFloat& open_float) {
    const std::string extremes = ": coordinates reach " + number(demands_.extent) +
                                 ", the smallest size is " + number(demands_.feature);
    const double off = rounding_error(demands_, demands_.unit_roundoff);
    if (!open_float) {
        say("precision", "as given");
    } else if (off > limit() / 2) {
        say("precision", "double, though its roundings may show" + extremes +
                             "; every ray is decided with --precision exact");
    } else if (rounding_error(demands_, float_roundoff) > limit() / 2) {
        say("precision", "double: roundings of float may show" + extremes);
    } else if (std::chrono::duration<double>(read_ - start_).count() >
               choice_.expected.seconds / 10) {
        say("precision", "double: to read the scene in float takes more than it could save");
    } else if (no_time_to_try()) {
        say("precision", "double: float would do, but there is no time to try it");
    } else {
        Trials& other = open_float();
        other.arrange(hierarchy_from_);
        const auto [in_double, in_float] = in_turn(
            choice_.expected.look, [this]() -> const Trials& { return trials_; },
            [&other]() -> const Trials& { return other; });
        if (in_float < gain * in_double) {
            choice_.in_float = true;
            choice_.expected.seconds *= in_float / in_double;
        }
        say("precision",
            (choice_.in_float ? "float: as good here, in " : "double: float would do, in ") +
                number(in_float / in_double) + " of the time");
    }
}

/// What is known to be off: samples, the reflections that are left out, roundings.
std::string Chooser::expected_error() const {
    if (demands_.sized_lights && aim_.given.shadow_samples) return "";
    double error =
        rounding_error(demands_, choice_.in_float ? float_roundoff : demands_.unit_roundoff);
    error = std::max(error, choice_.expected.error);
    if (demands_.mirrors && !aim_.given.depth) error = std::max(error, limit());
    return ", and 99 of 100 pixels within " + steps(error);
}

Choice Chooser::done() {
    const double seconds = choice_.expected.seconds;
    const bool too_long = aim_.time && seconds > 1.1 * *aim_.time;
    say("expected", number(seconds) + " s" + expected_error() +
                        (too_long ? ": nothing else can be spared" : ""));
    say("trials", std::to_string(pixels_) + " of the pixels, " + number(since(read_)) + " s");
    return std::move(choice_);
}

}  // namespace

std::optional<Choice> choose(Trials& trials, const OpenFloat& open_float, const Aim& aim,
                             Clock::time_point start, const std::atomic<bool>& stop) {
    Chooser chooser(trials, aim, start, stop);
    try {
        chooser.choose_hierarchy();
        chooser.choose_depth();
        chooser.choose_samples();
        chooser.choose_precision(open_float);
        return chooser.done();
    } catch (const Stopped&) {
        return std::nullopt;
    }
}

}  // namespace rt
