// Writes tests/programs/pictures/<name>.png: the spread of right answers around
// docs/pictures/<name>.png.
#include "tests/programs/pictures/spread.hpp"

#include "common/image/png.hpp"
#include "common/system/input_error.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace {

/// A larger spread is an edge, where a color does not distinguish right from wrong.
constexpr int most_judged = 16;

void make(const std::string& name) {
    const rt::Image reference = rt::read_png(RAYSTEPS_ROOT "/docs/pictures/" + name + ".png");
    rt::Image spread(reference.resolution);
    rt::f32::widen(spread, reference, name);
    rt::f64::widen(spread, reference, name);
    int left_out = 0;
    for (rt::Rgb& pixel : spread.pixels) {
        if (*std::max_element(pixel.begin(), pixel.end()) <= most_judged) continue;
        pixel = {rt::not_judged, rt::not_judged, rt::not_judged};
        ++left_out;
    }
    rt::write_png(RAYSTEPS_ROOT "/tests/programs/pictures/" + name + ".png", spread, {});
    std::printf("%-24s %.2f %% of the pixels are not judged\n", name.c_str(),
                100.0 * left_out / double(spread.pixels.size()));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        for (int i = 1; i < argc; ++i) make(argv[i]);
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    return 0;
}
