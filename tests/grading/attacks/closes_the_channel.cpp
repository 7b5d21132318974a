// attack: closes the channel, and goes on computing
// ceiling: as a stub
// message: closed the channel
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    close(3);
    for (volatile int i = 0;;) i = i + 1;
}

}  // namespace rt
