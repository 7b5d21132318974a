// Writes a mesh as text, the same bytes every time.
#pragma once

#include "scenes/meshes/polygons.hpp"

#include <string>

namespace rt {

/// The text of an OFF, OBJ, PLY or STL file, as the name says, with so many decimals at most. An
/// STL has triangles; the others keep faces as they are.
[[nodiscard]] std::string mesh_text(const Polygons& polygons, const std::string& file,
                                    int decimals);

}  // namespace rt
