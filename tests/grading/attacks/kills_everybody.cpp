// attack: kills every process it can
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>
#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    kill(-1, SIGKILL);
    return std::nullopt;
}

}  // namespace rt
