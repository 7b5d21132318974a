// Where the documents are wrong (docs/errata.md): what is printed, worked out in numbers, fails,
// and what holds, holds. The numbers are small and whole, so that both are exact. Each erratum has
// a case of its number, in the suite of its document: errata_mrt_test.cpp and its neighbours.
#pragma once

#include "tests/kit/verdict.hpp"

#include "common/shapes.hpp"

namespace rt {

inline const Sphere unit_sphere{.center = {0, 0, 0}, .radius = 1};
inline const Ray five_before{.origin = {0, 0, 5}, .direction = {0, 0, -1}};

}  // namespace rt
