// attack: tries to outlive its parent
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/prctl.h>
#include <unistd.h>
#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    prctl(PR_SET_PDEATHSIG, 0);
    for (;;) sleep(1000);
}

}  // namespace rt
