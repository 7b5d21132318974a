// The rays through pixels that --tolerance and --time choose, for model scenes with known errors
// and costs.
#include "tests/common/tuning/model_scenes.hpp"
#include "tests/kit/catch.hpp"

#include "common/tuning/pixel_study.hpp"

#include <numeric>

using namespace rt;

TEST_CASE("rays through pixels keep the tolerance beside edges, at about the least cost") {
    for (const Resolution size : {Resolution{320, 240}, Resolution{640, 480}}) {
        std::vector<double> costs;  // of picture and trials, in units of the cheapest setting
        for (const double edges : {0.02, 0.1, 0.4})
            for (const double allowed : {1.0, 2.0, 8.0}) {
                ModelScene model = plain();
                model.size = size;
                model.edges = edges;
                const RenderSettings settings =
                    chosen(model, {.tolerance = allowed}).expected.settings;
                INFO(size.width << " pixels wide, " << edges << " of them on edges, tolerance "
                                << allowed);
                REQUIRE(settings.pixel_error > 0);
                // 1 in 100, and a trial's luck.
                CHECK(beyond_on_edges(model, settings.pixel_error, allowed) <= 0.0105);
                double error = 32 * allowed;
                while (beyond_on_edges(model, error, allowed) > 0.01) error *= 0.98;
                const auto rays = [&](double pixel_error) {
                    return 1 + edges * stopped_rays(pixel_error);
                };
                const double trials = model.spent / model.ray_cost / model.pixels();
                costs.push_back((rays(settings.pixel_error) + trials) / rays(error));
            }
        CHECK(std::reduce(costs.begin(), costs.end()) / double(costs.size()) <=
              (size.width < 640 ? 1.3 : 1.2));
    }
}

TEST_CASE("every pixel gets rays only if no rays beside edges keep the tolerance") {
    for (const double estimated : {1.0, 0.7, 0.5, 0.35, 0.2})
        for (const double allowed : {1.0, 2.0, 4.0, 8.0}) {
            ModelScene model = plain();
            model.size = {.width = 320, .height = 240};
            model.edges = 0.4;
            model.estimated = estimated;
            INFO("tolerance " << allowed << ", errors are estimated as " << estimated);
            CHECK(chosen(model, {.tolerance = allowed}).expected.settings.pixel_error > 0);
        }
}

TEST_CASE("the time of rays that the picture keeps is not that of the trials") {
    const auto trial_seconds = [](ModelScene model, const Aim& aim) {
        for (const std::string& reason : chosen(model, aim).reasons)
            if (reason.starts_with("  trials ")) {
                const std::size_t end = reason.rfind(" s by the clock");
                return std::stod(reason.substr(reason.rfind(' ', end - 1) + 1));
            }
        return -1.0;
    };
    ModelScene model = plain();
    model.size = {.width = 64, .height = 48};
    model.edges = 0.1;
    const double others = trial_seconds(model, {.tolerance = 2});
    CHECK(others >= 0);
    model.center_time = std::chrono::seconds(3);
    CHECK(trial_seconds(model, {.tolerance = 2}) < others + 2);  // on a busy machine
}

TEST_CASE("trial pixels cost a small part of a small picture") {
    for (const int width : {160, 320}) {
        ModelScene model = plain();
        model.size = {.width = width, .height = width * 3 / 4};
        model.edges = 0.1;
        const Trial trial = chosen(model, {.tolerance = 2}).expected;
        INFO(width << " pixels wide");
        CHECK(model.spent / model.ray_cost <=
              (width < 320 ? 0.6 : 0.25) * trial.rays * model.pixels());
    }
}

TEST_CASE("a tolerance that no number of rays keeps gets the most rays, and an end") {
    ModelScene model = plain();
    model.size = {.width = 64, .height = 48};
    model.edges = 0.2;
    for (const double allowed : {0.05, 1e-3, 1e-300})
        CHECK(chosen(model, {.tolerance = allowed}).expected.settings.pixel_samples ==
              right_pixel_samples);
}

TEST_CASE("one ray through a pixel is enough where there are hardly any edges") {
    ModelScene model = plain();
    model.edges = 0.002;
    const RenderSettings settings = chosen(model, {.tolerance = 2}).expected.settings;
    CHECK(settings.pixel_samples == 1);
    CHECK(settings.pixel_error == 0);
}

TEST_CASE("all pixels get rays if edges are lost beside which no ray through a center finds them") {
    ModelScene model = plain();
    model.edges = 0.2;
    model.lost = 0.5;
    const RenderSettings settings = chosen(model, {.tolerance = 2}).expected.settings;
    CHECK(settings.pixel_samples >= 64);
    CHECK(settings.pixel_error == 0);
}

TEST_CASE("rare edges that the first trial pixels miss are traced when they are found") {
    ModelScene model = plain();
    model.size = {.width = 16384, .height = 16};
    model.edges = 1.0 / model.size.width;  // one column
    ModelTrials trials(model);
    TrialRunner runner(model.size, {.tolerance = 2}, going_on);
    PixelStudy study(runner, trials, {}, 2, false);
    study.begin(1);
    for (int times = 0; times < 8; ++times) {
        study.grow(2);
        const PixelStudy::Outcome outcome = study.outcome({});
        CHECK(outcome.at_most() < 0.02);  // false for a NaN
        CHECK(outcome.rays < 1);
    }
}

TEST_CASE("a given number of rays through a pixel stays") {
    ModelScene model = plain();
    model.edges = 0.2;
    for (const Aim& aim : {Aim{.tolerance = 2}, Aim{.time = 1}}) {
        Aim fixed = aim;
        fixed.settings.pixel_samples = 4;
        fixed.given.pixel_samples = true;
        CHECK(chosen(model, fixed).expected.settings.pixel_samples == 4);
        CHECK(chosen(model, fixed).expected.settings.pixel_error == 0);
    }
}

TEST_CASE("a time is filled by rays through pixels, beside edges first") {
    ModelScene model = plain();
    model.edges = 0.2;
    model.ray_cost = 1e-5;  // 3 s for one ray through each pixel
    const AutoSettings little = chosen(model, {.time = 30});
    CHECK(little.expected.settings.pixel_error > 0);
    CHECK(little.expected.seconds == Approx(30).epsilon(0.1));
    CHECK(little.pace != nullptr);
    model.lost = 0.5;
    const AutoSettings much = chosen(model, {.time = 1000});
    CHECK(much.expected.settings.pixel_error == 0);
    CHECK(much.expected.settings.pixel_samples > 64);
    CHECK(much.expected.seconds == Approx(1000).epsilon(0.1));
}

TEST_CASE("a light with a size gets more rays, the more of what it shades is in a penumbra") {
    const auto rays = [](double penumbra, std::size_t shapes) {
        ModelScene model = soft(penumbra);
        model.shadow = 0.5 - penumbra;
        model.edges = 0.1;
        model.traits.shapes = shapes;
        return chosen(model, {.tolerance = 2}).expected.settings.shadow_samples;
    };
    CHECK(rays(0.5, 8) == 32);
    CHECK(rays(0.05, 8) == 32);
    CHECK(rays(0.015, 8) == 16);
    CHECK(rays(0, 8) == 8);
    CHECK(rays(0.5, 1000) == 16);
    CHECK(rays(0, 1000) == 8);
}

TEST_CASE("a light with a size that shades nothing gets 32 rays, which it never sends") {
    ModelScene model = soft(0);
    model.edges = 0.1;
    CHECK(chosen(model, {.tolerance = 2}).expected.settings.shadow_samples == 32);
}

TEST_CASE("a light with a size gets 4 rays if time is short") {
    ModelScene model = soft(0.5);
    model.edges = 0.1;
    model.ray_cost = 1e-5;  // 3 s for one ray through each pixel
    const auto rays = [&](double seconds) {
        return chosen(model, {.time = seconds}).expected.settings.shadow_samples;
    };
    CHECK(rays(1000) == 32);
    CHECK(rays(5) == 4);
}

TEST_CASE("a time that is too short leaves one ray through each pixel") {
    ModelScene model = plain();
    model.edges = 0.1;
    model.ray_cost = 1e-5;  // 3 s for one ray through each pixel
    const AutoSettings choice = chosen(model, {.time = 1});
    CHECK(choice.expected.settings.pixel_error == largest_pixel_error);
    CHECK(choice.pace->next().pixel_error == largest_pixel_error);
}

TEST_CASE("much time is filled down to an estimated error of half a level") {
    ModelScene model = plain();
    model.edges = 0.2;
    model.ray_cost = 1e-5;
    CHECK(chosen(model, {.time = 1e5}).expected.settings.pixel_error == 0.5);
}

TEST_CASE("a time is not filled where more rays change nothing that is seen") {
    ModelScene model = plain();
    model.edges = 0.001;
    model.ray_cost = 1e-5;
    for (double seconds = 250; seconds < 1000; seconds *= 1.05) {
        INFO(seconds << " s");
        CHECK(chosen(model, {.time = seconds}).expected.settings.pixel_error > 0);
    }
}
