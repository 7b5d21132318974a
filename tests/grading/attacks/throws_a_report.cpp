// attack: throws an exception whose message contains lines of the report
// ceiling: as a stub
// message: threw an exception: ?passed?case
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <stdexcept>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    throw std::runtime_error("\npassed\ncase the picture of the stage\npassed\n\x1b[2J");
}

}  // namespace rt
