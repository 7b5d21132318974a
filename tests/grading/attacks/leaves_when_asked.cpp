// attack: prints Catch2's output of a success, and exits with status 0
// ceiling: as a stub
// message: ended the program, with status 0
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdio>
#include <cstdlib>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::puts("All tests passed (53 assertions in 19 test cases)");
    std::exit(0);
}

}  // namespace rt
