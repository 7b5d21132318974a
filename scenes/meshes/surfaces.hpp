// Meshes that a formula gives.
#pragma once

#include "scenes/meshes/polygons.hpp"

namespace rt {

/// The cube from −1 to 1, each face two triangles.
[[nodiscard]] Polygons cube();

/// The icosahedron, its edges cut into n: 20 n² flat triangles around 0.
[[nodiscard]] Polygons cut_icosahedron(int n);

/// A sphere with hills of four sizes: the cut icosahedron's vertices, moved in and out.
[[nodiscard]] Polygons hilly_sphere(int n);

/// The cage of a pebble: an icosahedron, drawn out and dented.
[[nodiscard]] Polygons pebble_cage();

/// A bowl that is one sheet, open at the top: a surface of revolution whose rim is a hole of
/// `corners` edges.
[[nodiscard]] Polygons bowl(int corners);

/// Open pages that share their spine: an edge of seven faces, which no manifold has.
[[nodiscard]] Polygons book();

}  // namespace rt
