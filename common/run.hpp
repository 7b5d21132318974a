// What a stage's program does once it knows what is asked for.
#pragma once

#include "common/options.hpp"
#include "common/real.hpp"

#include <atomic>

namespace rt::inline RT_PRECISION {

/// Reads the scene; renders it, or tells one pixel's story; says what came of it. Returns false,
/// and leaves no file, if it was stopped. Throws InputError for what is wrong with the scene.
[[nodiscard]] bool run(const Program& program, const Options& options,
                       const std::atomic<bool>& stop);

}  // namespace rt::inline RT_PRECISION
