// Whether shapes of a kind are in a hierarchy, or are asked with balls around them.
#pragma once

#include "common/trial_runner.hpp"

#include <optional>
#include <string>

namespace rt {

struct HierarchyChoice {
    std::optional<std::size_t> from;  ///< as --hierarchy-from; nothing if it is as usual
    std::string why;
};

/// Tries both where the number of shapes does not tell which is quicker, and arranges the scene.
/// The picture is the same, but where surfaces coincide.
[[nodiscard]] HierarchyChoice choose_hierarchy(TrialRunner& runner, Trials& trials,
                                               const Demands& demands, const Look& look);

}  // namespace rt
