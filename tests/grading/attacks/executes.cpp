// attack: starts a shell
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    execl("/bin/sh", "sh", "-c", "echo harm >> @RESULTS@", nullptr);
    return std::nullopt;
}

}  // namespace rt
