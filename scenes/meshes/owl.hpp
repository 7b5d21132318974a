// The owl: the project's own character.
#pragma once

#include "scenes/meshes/polygons.hpp"

namespace rt {

/// A cage of closed parts, to be rounded by Catmull and Clark's rule. It stands on y = 0, a little
/// more than 2 high, and looks along z.
[[nodiscard]] Polygons owl_cage();

}  // namespace rt
