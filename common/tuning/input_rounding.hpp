// Loss of accuracy when the numbers of a scene are rounded: sizes and gaps that are small compared
// to the coordinates, in float much sooner than in double.
#pragma once

#include "common/scene/scene.hpp"
#include "common/tuning/scene_lengths.hpp"

#include <string>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

/// The lengths of a scene in double precision; a scene in float has already lost them. Meshes count
/// if they are loaded.
[[nodiscard]] SceneLengths scene_lengths(const Scene& scene);

/// As scene_lengths, without the gap, which takes longest to find.
[[nodiscard]] SceneLengths scene_sizes(const Scene& scene);

}  // namespace RT_PRECISION

inline namespace f64 {

/// Returns one sentence for each thing in the scene that float would lose; empty if there is no
/// risk.
[[nodiscard]] std::vector<std::string> risks_in_float(const SceneLengths& scene);

/// As risks_in_float, for double.
[[nodiscard]] std::vector<std::string> risks_in_double(const SceneLengths& scene);

}  // namespace f64
}  // namespace rt
