// The picture of a scene, as a file.
#pragma once

#include "common/program/options.hpp"
#include "common/render/render.hpp"
#include "common/tuning/time_budget.hpp"

#include <atomic>

namespace rt {

/// The result of render_centers, and the seconds by the clock that it took.
struct TracedCenters {
    Rendering rendering;
    double seconds = 0;
};

/// Renders the scene, writes the picture with its legend, and reports the result, with the seconds
/// by the clock of both. `centers`, if not null, is that of the same settings, and is moved from. A
/// time budget `pace`, if not null, changes the settings from row to row. Returns false, and leaves
/// no file, if it was stopped.
[[nodiscard]] bool make_picture(const Program& program, const Options& options, const Scene& scene,
                                TracedCenters* centers, TimeBudget* pace,
                                const std::atomic<bool>& stop);

}  // namespace rt
