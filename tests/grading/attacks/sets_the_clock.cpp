// attack: puts the clock forward
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <ctime>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    timespec later{};
    clock_settime(CLOCK_REALTIME, &later);
    return std::nullopt;
}

}  // namespace rt
