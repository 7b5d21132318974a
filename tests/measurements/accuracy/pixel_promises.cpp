// What --tolerance promises of the rays through pixels: of every scene, the picture with the chosen
// settings beside one of 1,024 rays through each pixel. The arguments are the tolerance, one
// scene, and the width.
#include "common/program/session.hpp"
#include "common/tuning/candidates.hpp"
#include "common/tuning/trial_pixels.hpp"

#include "tests/measurements/accuracy/drawing.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>

using namespace rt;

namespace {

Resolution size{.width = 160, .height = 120};
const std::atomic<bool> going_on = false;

/// The largest mean difference of a tile.
double worst_tile(const Image& a, const Image& b) {
    std::map<int, std::pair<double, int>> tiles;
    for (Pixel pixel; pixel.row < size.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < size.width; ++pixel.column) {
            int most = 0;
            for (std::size_t i = 0; i < 3; ++i)
                most = std::max(most, std::abs(a[pixel][i] - b[pixel][i]));
            auto& [sum, count] = tiles[tile_of(pixel, size)];
            sum += most;
            ++count;
        }
    double worst = 0;
    for (const auto& [tile, sums] : tiles) worst = std::max(worst, sums.first / sums.second);
    return worst;
}

double share_beyond(const Image& a, const Image& b, double tolerance) {
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(a.pixels[i][c] - b.pixels[i][c]));
        beyond += most > tolerance;
    }
    return double(beyond) / double(a.pixels.size());
}

/// The largest --pixel-error, in steps of a tenth, with which the picture keeps the promise, with
/// all else as chosen, and the time of that picture.
std::pair<double, double> coarsest(const Drawer& draw, RenderSettings settings, const Image& exact,
                                   double tolerance) {
    std::pair found{settings.pixel_error, 0.0};
    if (settings.pixel_error == 0) return found;
    for (; settings.pixel_error < 255; settings.pixel_error *= 1.1) {
        const Drawing picture = draw(settings);
        if (share_beyond(picture.image, exact, tolerance) > 0.01 ||
            worst_tile(picture.image, exact) > 2 * tolerance)
            return found;
        found = {settings.pixel_error, picture.seconds};
    }
    return found;
}

void measure(const std::filesystem::path& scene, double tolerance) {
    Options options{};
    options.scene = scene.string();
    options.size = size;
    options.tolerance = tolerance;
    const auto session = f64::make_renderer({.stage = 13, .root = RAYSTEPS_ROOT}, options);
    RenderSettings right{.pixel_samples = 1024, .depth = 64};
    if (session->traits().sized_lights) right = with_rays(right, 1);
    const Drawer draw = f64::drawer(scene.string(), size);
    const Drawing exact = draw(right);
    const std::clock_t start = std::clock();
    const auto choice = choose(*session, {}, options, Clock::now(), going_on);
    const double trials = double(std::clock() - start) / CLOCKS_PER_SEC;
    const RenderSettings& settings = choice->expected.settings;
    const Drawing picture = draw(settings);
    const Difference before = difference(draw({}).image, exact.image);
    const Difference off = difference(picture.image, exact.image);
    const auto [largest, seconds] = coarsest(draw, settings, exact.image, tolerance);
    std::printf("%s,%g,%d,%g,%g,%d,%.5f,%.3f,%.3f,%.3f,%.3f,%.4f,%g,%.2f\n", scene.stem().c_str(),
                tolerance, settings.pixel_samples, settings.pixel_error, settings.shadow_error,
                settings.shadow_agree, share_beyond(picture.image, exact.image, tolerance),
                worst_tile(picture.image, exact.image), before.error, off.error,
                picture.seconds / exact.seconds, trials / exact.seconds, largest,
                picture.seconds / seconds);
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
    const double tolerance = count > 1 ? std::atof(arguments[1]) : 2;
    const std::string only = count > 2 ? arguments[2] : "";
    if (count > 3) size.width = std::atoi(arguments[3]);
    size.height = size.width * 3 / 4;
    std::puts(
        "scene,tolerance,samples,pixel_error,shadow_error,shadow_agree,beyond,worst_tile,"
        "error_of_defaults,error,time,trials,coarsest,beside_coarsest");
    for (const auto& scene : scenes_for_choices())
        if (only.empty() || scene.stem() == only) measure(scene, tolerance);
}
