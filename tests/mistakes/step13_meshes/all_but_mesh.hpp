// The reference, whose `intersect` with a mesh is correct_intersect: for mistakes in that one.
#pragma once

#include "tests/mistakes/step13_meshes/stage5.hpp"

#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const OrientedBox& box, Interval interval) {
    return correct_intersect(ray, box, interval);
}

}  // namespace rt
