// Rounder meshes, by OpenMesh's subdivision.
#pragma once

#include "scenes/meshes/polygons.hpp"

namespace rt {

/// Each time, every face of n corners becomes n quadrilaterals (Catmull, Clark 1978).
[[nodiscard]] Polygons catmull_clark(const Polygons& polygons, int times);

/// Each time, every triangle becomes four (Loop 1987). All faces must be triangles.
[[nodiscard]] Polygons loop(const Polygons& polygons, int times);

/// With a normal a vertex, the mean of its faces' weighted by their angles there.
[[nodiscard]] Polygons with_normals(Polygons polygons);

}  // namespace rt
