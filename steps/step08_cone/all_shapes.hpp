// The shapes of stages 3 to 8, for the later stages.
#pragma once

#include "common/render/closest_hit.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

namespace rt {

/// Tests a closest-hit or any-hit query against all these shapes, as stage 8's main.cpp does.
template <class Query>
void visit_shapes(Query& query, const Scene& scene) {
    query.test(scene.spheres);
    query.test(scene.planes);
    query.test(scene.triangles);
    query.test(scene.squares);
    query.test(scene.cylinders);
    query.test(scene.cones);
}

}  // namespace rt
