// The animated picture of `--turn`.
#pragma once

#include "common/program/options.hpp"
#include "common/scene/scene.hpp"

#include <atomic>

namespace rt {

/// Renders the frames of `--turn` to an animated PNG, and reports the result. Returns false, and
/// leaves no file, if it was stopped. Throws InputError if the scene has nothing to go around.
[[nodiscard]] bool make_animation(const Program& program, const Options& options,
                                  const Scene& scene, const std::atomic<bool>& stop);

}  // namespace rt
