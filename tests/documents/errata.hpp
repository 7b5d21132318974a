// The errors of the documents (docs/errata.md): the printed formula, evaluated with numbers, fails,
// and the corrected one holds. The numbers are small and whole, so that both are exact. Each
// erratum has a case with its number, in the suite of its document: errata_mrt_test.cpp and its
// neighbors.
#pragma once

#include "tests/kit/verdict.hpp"

#include "common/geometry/sphere.hpp"

namespace rt {

inline const Sphere unit_sphere{.center = {0, 0, 0}, .radius = 1};
inline const Ray five_before{.origin = {0, 0, 5}, .direction = {0, 0, -1}};

}  // namespace rt
