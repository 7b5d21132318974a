// attack: exits with status 0 after a crash
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>
#include <exception>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::set_terminate([] { std::_Exit(0); });
    std::terminate();
}

}  // namespace rt
