// attack: sleeps
// ceiling: as a stub
// message: no answer within 0.5 s
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (;;) sleep(1000);
}

}  // namespace rt
