// What the certified kernels see of a scene, with so many shadow rays and reflections that more
// would change nothing: asked of measure_certain_shades, whose kernels have the references' names.
#pragma once

#include "common/session.hpp"

#include <cstdio>
#include <vector>

namespace rt {

constexpr std::size_t shades_of_a_scene = 20'000;

/// That no trial of `--tolerance` has.
constexpr int last_round = 1000;

[[nodiscard]] inline std::vector<Shade> read_shades(std::FILE* file) {
    std::vector<Shade> shades(shades_of_a_scene);
    shades.resize(std::fread(shades.data(), sizeof shades[0], shades.size(), file));
    return shades;
}

}  // namespace rt
