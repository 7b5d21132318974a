// attack: leaves the processor to others without end, and uses little time of its own
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sched.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (;;) sched_yield();
}

}  // namespace rt
