// Writes a mesh as text, the same bytes every time.
#pragma once

#include "scenes/meshes/polygons.hpp"

#include <string>

namespace rt {

/// The text of an OFF, OBJ, PLY or STL file, as its ending says, with at most `decimals` decimals.
/// An STL has triangles; the others keep faces as they are.
[[nodiscard]] std::string mesh_text(const Polygons& polygons, const std::string& file,
                                    int decimals);

}  // namespace rt
