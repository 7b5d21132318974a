// Prints the shades of every scene, three doubles each: certain_shades.hpp.
#include "tests/measurements/accuracy/certain_shades.hpp"
#include "tests/measurements/accuracy/drawing.hpp"

using namespace rt;

int main() {
    const Program program{.stage = 13, .root = RAYSTEPS_ROOT, .exact = true};
    const RenderSettings converged{
        .shadow_samples = most_shadow_samples, .shadow_error = 1.0 / 16, .depth = 64};
    for (const auto& scene : scenes_for_choices()) {
        Options options;
        options.scene = scene.string();
        const auto session = f64::make_renderer(program, options);
        const std::vector<Pixel> pixels = certain_pixels(session->resolution());
        const TrialSample sample =
            session->render_pixels(converged, {.pixels = pixels, .round = last_round});
        std::fwrite(sample.shades.data(), sizeof sample.shades[0], sample.shades.size(), stdout);
        std::fflush(stdout);
    }
}
