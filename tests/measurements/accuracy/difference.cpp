#include "tests/measurements/accuracy/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rt {

namespace {

/// In levels of 255, of the channel that differs most.
int levels(const Rgb& a, const Rgb& b) {
    int worst = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        worst = std::max(worst, std::abs(a[channel] - b[channel]));
    return worst;
}

bool is_edge(const Image& image, Pixel pixel) {
    constexpr int smooth = 8;
    const auto [width, height] = image.resolution;
    for (int row = std::max(pixel.row - 1, 0); row <= std::min(pixel.row + 1, height - 1); ++row)
        for (int column = std::max(pixel.column - 1, 0);
             column <= std::min(pixel.column + 1, width - 1); ++column)
            if (levels(image[{row, column}], image[pixel]) > smooth) return true;
    return false;
}

}  // namespace

namespace {

std::vector<std::filesystem::path> scenes_in(const char* folder) {
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".rt") scenes.push_back(entry.path());
    std::ranges::sort(scenes);
    return scenes;
}

}  // namespace

std::vector<std::filesystem::path> all_scenes() {
    return scenes_in(RAYSTEPS_ROOT "/scenes");
}

std::vector<std::filesystem::path> scenes_for_choices() {
    std::vector<std::filesystem::path> scenes = all_scenes();
    std::ranges::copy(scenes_in(RAYSTEPS_ROOT "/tests/measurements/accuracy/scenes"),
                      std::back_inserter(scenes));
    return scenes;
}

Difference difference(const Image& a, const Image& b) {
    Difference all;
    for (Pixel pixel; pixel.row < a.resolution.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < a.resolution.width; ++pixel.column) {
            const int worst = levels(a[pixel], b[pixel]);
            all.most = std::max(all.most, worst);
            all.error += worst * worst;
            all.other += worst > 0;
            all.seen += worst > 2;
            all.edges += worst > 0 && is_edge(b, pixel);
        }
    const auto count = double(a.pixels.size());
    all.error = std::sqrt(all.error / count);
    all.other /= count;
    all.seen /= count;
    all.edges /= count;
    return all;
}

}  // namespace rt
