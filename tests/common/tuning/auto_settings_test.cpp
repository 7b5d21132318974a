// The choices of --tolerance and --time, for model scenes with known errors and costs.
#include "tests/common/tuning/model_scenes.hpp"
#include "tests/kit/catch.hpp"

#include "common/tuning/wording.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace rt;

TEST_CASE(
    "a tolerance is kept by 99 of 100 pixels, and 9 of 10 in penumbrae, at about the least "
    "cost") {
    for (const Resolution size : {Resolution{320, 240}, Resolution{640, 480}}) {
        std::vector<double> costs;  // of picture and trials, in units of the cheapest setting
        for (const double penumbra : {0.03, 0.1, 0.3, 1.0})
            for (const double allowed : {0.5, 1.0, 2.0, 8.0}) {
                ModelScene model = soft(penumbra);
                model.size = size;
                const RenderSettings settings =
                    chosen(model, {.tolerance = allowed}).expected.settings;
                INFO(size.width << " pixels wide, " << penumbra
                                << " of them in a penumbra, tolerance " << allowed);
                CHECK(keeps(model, error_of(settings), allowed));
                double error = 40;
                while (!keeps(model, error, allowed)) error *= 0.99;
                const double cheapest =
                    cost_of(model, {.shadow_samples = 1, .shadow_error = 1.5 * error});
                costs.push_back((cost_of(model, settings) + model.spent) / cheapest);
                CHECK(costs.back() <= 2);  // a trial's luck
            }
        CHECK(std::reduce(costs.begin(), costs.end()) / double(costs.size()) <=
              (size.width < 640 ? 1.7 : 1.6));
    }
}

TEST_CASE("a rare penumbra keeps the tolerance too") {
    for (const double penumbra : {0.004, 0.009})
        for (const double allowed : {0.5, 1.0, 2.0, 8.0}) {
            ModelScene model = soft(penumbra);
            const RenderSettings settings = chosen(model, {.tolerance = allowed}).expected.settings;
            INFO(penumbra << " of the pixels in a penumbra, tolerance " << allowed);
            CHECK(beyond(error_of(settings), allowed) <= 0.1);
        }
}

TEST_CASE("trials shrink with the picture and its penumbrae") {
    // In units of one ray for every pixel, somewhat more than was measured.
    for (const auto& [allowed, most] : {std::pair(1.0, 3.6), std::pair(4.0, 0.68)}) {
        ModelScene model = soft(0.003);  // one column, of which trials could draw every pixel
        model.size = {.width = 320, .height = 60};
        (void)chosen(model, {.tolerance = allowed});
        INFO("tolerance " << allowed);
        CHECK(model.spent <= most * model.pixels() * model.ray_cost);
    }
}

TEST_CASE("mirrors are followed until no more than a part of the tolerance is missing") {
    for (const double mirror : {0.05, 0.5, 0.9})
        for (const double allowed : {0.5, 2.0, 7.0, 30.0}) {
            const int depth = sufficient_depth(mirror, allowed);
            INFO("mirrors of " << mirror << ", tolerance " << allowed << ", depth " << depth);
            CHECK(255 * std::pow(mirror, depth + 1) <= allowed / 8);
            if (depth > 0) CHECK(255 * std::pow(mirror, depth) > allowed / 8);
        }
    ModelScene model = plain();
    model.traits.strongest_mirror = 0.5;
    model.reflections = 100;
    // 255 / 2^11 < 1 / 8, and of light of 100 levels 100 / 2^10 < 1 / 8.
    CHECK(chosen(model, {.tolerance = 1}).expected.settings.depth == 10);
    for (const int reflections : {1, 3, 6}) {
        model.reflections = reflections;
        CHECK(chosen(model, {.tolerance = 1}).expected.settings.depth == reflections);
    }
    model.traits.strongest_mirror = 0.9;
    model.reflections = 6;  // of the 72 that a mirror of this strength could show
    CHECK(chosen(model, {.tolerance = 1}).expected.settings.depth == 6);
    CHECK(chosen(model, {.settings = {.depth = 5}, .tolerance = 1, .given = {.depth = true}})
              .expected.settings.depth == 5);
}

TEST_CASE("features that a scene does not use are not tried") {
    ModelScene model = plain();
    const AutoSettings choice = chosen(model, {.settings = {.depth = 8}, .tolerance = 1});
    CHECK(choice.expected.settings.depth == 8);
    CHECK(choice.expected.settings.shadow_samples == RenderSettings().shadow_samples);
    CHECK(model.asked <= 200);  // the trials that estimate the time
}

TEST_CASE("float is taken where it draws the same, by no clock") {
    for (const double feature : {1.0, 1e-3})
        for (const double penumbra : {0.004, 0.5})
            for (const double other : {0.0, 1e-4, 3e-3, 0.06}) {
                ModelScene model = soft(penumbra);
                model.traits.lengths.smallest = feature;
                ModelScene in_float = model;
                in_float.other = other;
                in_float.clock_noise = model.clock_noise = 5;
                bool opened = false;
                ModelTrials known(in_float);
                const OpenFloat open_float = [&]() -> Trials& {
                    opened = true;
                    return known;
                };
                const AutoSettings choice = chosen(model, {.tolerance = 1}, open_float);
                INFO("sizes from " << feature << ", " << penumbra << " in a penumbra, float has "
                                   << other << " wrong");
                const bool tried =
                    feature == 1;  // 255 · 8 u · 10 / feature: 1e-3 of a level, or 1.2
                CHECK(opened == tried);
                CHECK(choice.in_float == (tried && other <= 1e-4));
            }
    ModelScene hard = plain();  // lights without a size, and few pixels
    hard.size = {.width = 200, .height = 150};
    hard.edges = 0.1;
    ModelTrials known(hard);
    CHECK(chosen(hard, {.tolerance = 1}, [&]() -> Trials& { return known; }).in_float);
    CHECK_FALSE(chosen(hard, {.tolerance = 1}).in_float);  // a program that cannot open it
}

TEST_CASE("float is not tried where it may lose a gap") {
    ModelScene model = soft(0.5);
    ModelTrials known(model);
    // 4 · 8 u · 10 is 2e-5.
    for (const double gap : {0.0, 1e-8, 1.8e-5, 2e-5, 1.0}) {
        model.traits.lengths.gap = gap;
        INFO("a gap of " << gap);
        CHECK(chosen(model, {.tolerance = 1}, [&]() -> Trials& { return known; }).in_float ==
              (gap == 0 || gap > 1.9e-5));
    }
}

TEST_CASE("a tolerance chooses the same, however wrong the clock is") {
    ModelScene model = soft(0.1);
    const RenderSettings settings = chosen(model, {.tolerance = 1}).expected.settings;
    model.clock_noise = 10;
    for (int i = 0; i < 3; ++i) {
        const RenderSettings other = chosen(model, {.tolerance = 1}).expected.settings;
        CHECK(other.shadow_error == settings.shadow_error);
        CHECK(other.shadow_agree == settings.shadow_agree);
        CHECK(other.shadow_samples == settings.shadow_samples);
    }
}

TEST_CASE("a time is filled by shadow samples, and depth makes room for it") {
    for (const double seconds : {0.5, 1.0, 5.0}) {
        ModelScene model = soft(0.5);
        const AutoSettings choice = chosen(model, {.time = seconds});
        CHECK(choice.expected.seconds == Approx(seconds).epsilon(0.03));
        CHECK(cost_of(model, choice.expected.settings) == Approx(seconds).epsilon(0.1));
        CHECK(choice.pace != nullptr);
    }
    ModelScene model = plain();
    model.traits.strongest_mirror = 0.5;
    const AutoSettings choice = chosen(model, {.time = 1e-3});  // less than it takes at any depth
    CHECK(choice.expected.settings.depth == 0);
}

TEST_CASE("trials take a small part of the time, however often mirrors reflect") {
    for (const Resolution size : {Resolution{64, 48}, {160, 120}, {640, 480}, {1920, 1080}})
        for (const double reflections : {0., 10., 1000.})
            for (const double seconds : {0.2, 1., 3.}) {
                ModelScene model = plain();
                model.size = size;
                model.traits.strongest_mirror = 1;
                model.reflections = reflections;
                model.edges = 0.1;
                const RenderSettings settings = chosen(model, {.time = seconds}).expected.settings;
                INFO(size.width << " pixels wide, " << reflections << " reflections, " << seconds
                                << " s, depth " << settings.depth);
                CHECK(model.spent <= 0.35 * seconds);
                const double centers = model.pixels() * path_cost(model, settings);
                CHECK((settings.depth == 0 || centers <= 0.6 * seconds));
                // Deeper would take more than half of the time.
                CHECK((settings.depth >= reflections || centers >= 0.2 * seconds ||
                       2 * model.pixels() * model.ray_cost > 0.2 * seconds));
            }
}

TEST_CASE("no depth is found where one reflection takes too long") {
    ModelScene model = plain();
    model.traits.strongest_mirror = 1;
    model.reflections = 1000;
    model.reflection_cost = 100;
    const double centers = model.pixels() * model.ray_cost;
    CHECK(chosen(model, {.time = 10 * centers}).expected.settings.depth == 0);
    CHECK(chosen(model, {.time = 1000 * centers}).expected.settings.depth == 4);
}

TEST_CASE("no time is negative, and no error less than was sampled, however wrong the clock is") {
    for (int i = 0; i < 200; ++i) {
        ModelScene model = soft(0.01);
        model.clock_noise = 5;
        const AutoSettings choice = chosen(model, {.time = 1e-3 * (1 + i % 10)});
        CHECK(choice.expected.seconds > 0);
        CHECK(choice.expected.error >= 0);
    }
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-1.6, 1.6);
    for (int i = 0; i < 1000; ++i) {
        QualityLadder ladder;
        for (const double error : {16, 8, 4})
            ladder.add({.settings = {.shadow_error = error},
                        .seconds = (0.1 + 0.01 / error) * std::exp(noise(random)),
                        .error = error});
        const double sampled = ladder.top().error;
        const double last = ladder.top().seconds;
        std::vector<RenderSettings> finer;
        for (double error = 2.8; error > 0.03; error /= std::sqrt(2))
            finer.push_back({.shadow_error = error});
        ladder.extend(finer, 1);
        CHECK(ladder.top().seconds >= last);
        CHECK(ladder.top().error == sampled);
        double before = 0;
        for (double time = 1e-3; time < 10; time *= 1.1) {
            const Trial trial = ladder.within_time(time);
            CHECK(trial.seconds > 0);
            CHECK(trial.seconds >= before * (1 - 1e-9));
            CHECK(trial.error >= sampled * (1 - 1e-9));
            before = trial.seconds;
        }
    }
}

TEST_CASE("with a tolerance and a time, the time is the limit of the tolerance") {
    ModelScene model = soft(0.5);
    const Trial enough = chosen(model, {.tolerance = 2}).expected;
    const Trial within = chosen(model, {.tolerance = 2, .time = 10 * enough.seconds}).expected;
    CHECK(error_of(within.settings) <= 2);
    CHECK(within.seconds <= 4 * enough.seconds);  // not all of the time
    CHECK(chosen(model, {.tolerance = 2, .time = enough.seconds / 3}).expected.seconds ==
          Approx(enough.seconds / 3).epsilon(0.03));
}

TEST_CASE("trials can be stopped") {
    ModelScene model = soft(0.5);
    const std::atomic<bool> stopped = true;
    ModelTrials known(model);
    CHECK_FALSE(choose(known, {}, {.tolerance = 1}, Clock::now(), stopped));
}

TEST_CASE("a pace takes its time on a machine that is slower or faster than expected") {
    QualityLadder ladder;
    for (const double error : {16, 8, 4, 2, 1})
        ladder.add({.settings = {.shadow_error = error}, .seconds = 16 / error, .error = error});
    constexpr int rows = 480;
    for (const double slower : {0.4, 1.0, 3.0})
        for (const double wanted : {4.0, 12.0}) {
            const Clock::time_point start{};
            const auto at = [&](double seconds) {
                return start + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(seconds));
            };
            TimeBudget pace(ladder, rows, at(wanted));
            double now = 0;
            for (int row = 0; row < rows; ++row) {
                // The cost of a row varies with the golden ratio, between 0 and 2 times the mean.
                const double uneven = 2 * std::fmod(0.618033988749895 * row, 1.0);
                now += uneven * slower * 16 / pace.next(at(now)).shadow_error / rows;
            }
            INFO(slower << " times slower, " << wanted << " s");
            const double least = slower;      // all rows with the first setting
            const double most = 16 * slower;  // with the last
            CHECK(now == Approx(std::clamp(wanted, least, most)).epsilon(0.05));
        }
}

TEST_CASE("once the time is over, the fastest settings are left") {
    QualityLadder ladder;
    for (const double error : {16, 4, 1})
        ladder.add({.settings = {.shadow_error = error}, .seconds = 16 / error, .error = error});
    const Clock::time_point end{};
    for (const int late : {0, 1, 100}) {
        TimeBudget pace(ladder, 480, end);
        for (int row = 0; row < 3; ++row)
            CHECK(pace.next(end + std::chrono::milliseconds(late)).shadow_error == 16);
    }
}

TEST_CASE("rays that are traced before count for no row") {
    QualityLadder ladder;
    for (const double error : {16, 4, 1})
        ladder.add(
            {.settings = {.shadow_error = error}, .seconds = 5 + 16 / error, .error = error});
    ladder.shorten(5);
    CHECK(ladder.within_time(4).settings.shadow_error == Approx(4));
    ladder.shorten(100);
    CHECK(ladder.top().seconds > 0);
}

TEST_CASE("a threshold has two digits, and one that is computed is not one step lower") {
    CHECK(two_digits(std::pow(std::pow(2, 0.125), 16)) == 4);  // 3.9999999999999973
    CHECK(two_digits(1.4) == 1.4);                             // 1.4 / 0.1 is below 14
    CHECK(two_digits(3.99) == 3.9);
    CHECK(two_digits(127.9) == 120);
}
