// The colors that the certified kernels compute for a scene, with enough shadow rays and
// reflections that more would change nothing. They are computed by measure_certain_shades, whose
// kernels have the references' names.
#pragma once

#include "common/program/renderer.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

namespace rt {

constexpr std::size_t shades_of_a_scene = 20'000;

/// `count` of the picture's pixels, evenly spread: the golden ratio apart.
[[nodiscard]] inline std::vector<Pixel> certain_pixels(Resolution size) {
    std::vector<Pixel> pixels;
    const std::size_t all = std::size_t(size.width) * std::size_t(size.height);
    for (std::size_t i = 0; i < shades_of_a_scene; ++i) {
        const double part = 0.6180339887498949 * double(i);
        const auto place = std::size_t((part - std::floor(part)) * double(all));
        pixels.push_back({.row = int(place / std::size_t(size.width)),
                          .column = int(place % std::size_t(size.width))});
    }
    return pixels;
}

/// A round that no trial of `--tolerance` uses.
constexpr int last_round = 1000;

[[nodiscard]] inline std::vector<DisplayColor> read_shades(std::FILE* file) {
    std::vector<DisplayColor> shades(shades_of_a_scene);
    shades.resize(std::fread(shades.data(), sizeof shades[0], shades.size(), file));
    return shades;
}

}  // namespace rt
