// Whether a trace stops when an estimated error is small.
#include "tests/common/tuning/model_scenes.hpp"
#include "tests/kit/catch.hpp"

#include "common/tuning/auto_settings.hpp"

#include <algorithm>

using namespace rt;

namespace {

/// A trace that takes all samples of a light, whatever the error.
class EndlessTrials : public ModelTrials {
public:
    using ModelTrials::ModelTrials;

    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const TrialRequest& request) const override {
        RenderSettings all = settings;
        all.shadow_error = 0;
        TrialSample sample = ModelTrials::render_pixels(all, request);
        sample.rays = 1 + settings.shadow_samples;
        return sample;
    }
};

/// One that stops after as few samples as show an error.
class StoppingTrials : public EndlessTrials {
public:
    using EndlessTrials::EndlessTrials;

    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const TrialRequest& request) const override {
        TrialSample sample = EndlessTrials::render_pixels(settings, request);
        if (settings.shadow_error > 100) sample.rays = 1 + std::min(settings.shadow_samples, 8);
        return sample;
    }
};

}  // namespace

TEST_CASE("a trace that takes all samples of a light, whatever the error, is recognized") {
    ModelScene model = soft(0.1);
    CHECK_FALSE(stops_sampling(EndlessTrials(model), {}));
    CHECK(stops_sampling(StoppingTrials(model), {}));
    ModelScene without_light;
    CHECK(stops_sampling(ModelTrials(without_light), {}));
}
