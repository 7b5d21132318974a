// The choice between a bounding volume hierarchy and a list with bounding spheres for each kind of
// shape.
#pragma once

#include "common/tuning/trial_runner.hpp"

#include <optional>
#include <string>

namespace rt {

/// The chosen structure, and the reason for the report.
struct HierarchyChoice {
    std::optional<std::size_t> from;  ///< value for --hierarchy-from; nothing for the default
    std::string why;
};

/// Measures both where the number of shapes alone does not decide which is faster, and builds the
/// faster one for the scene. The picture is the same, except where surfaces coincide.
[[nodiscard]] HierarchyChoice choose_hierarchy(TrialRunner& runner, Trials& trials,
                                               const SceneTraits& traits,
                                               const RenderSettings& settings);

}  // namespace rt
