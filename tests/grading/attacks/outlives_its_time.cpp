// attack: ignores the signal at the end of its time
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::signal(SIGXCPU, SIG_IGN);
    for (volatile int i = 0;;) i = i + 1;
}

}  // namespace rt
