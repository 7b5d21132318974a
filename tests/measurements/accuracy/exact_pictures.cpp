// Renders every scene with the certified kernels, for measure_pictures. Output for each: the
// seconds, a double, and the pixels, three bytes each.
#include "tests/measurements/accuracy/drawing.hpp"

#include <cstdio>

using namespace rt;

int main() {
    for (const auto& scene : all_scenes()) {
        const Drawing drawing = f64::rendered(scene, {.width = 240, .height = 180}, {});
        const auto& pixels = drawing.image.pixels;
        std::fwrite(&drawing.seconds, sizeof drawing.seconds, 1, stdout);
        std::fwrite(pixels.data(), sizeof pixels[0], pixels.size(), stdout);
        std::fflush(stdout);
    }
}
