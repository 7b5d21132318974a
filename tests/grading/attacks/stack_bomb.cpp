// attack: calls itself without end
// ceiling: as a stub
// message: crashed
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

namespace {

int deeper(volatile int* above) {
    volatile int here[1000] = {*above};
    return deeper(here) + here[1];
}

}  // namespace

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    volatile int start = 0;
    return deeper(&start);
}

}  // namespace rt
