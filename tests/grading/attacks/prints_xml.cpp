// attack: prints a whole XML report of success
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <iostream>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::cout
        << "<?xml version=\"1.0\"?><testsuites><testsuite name=\"step03_sphere\" errors=\"0\" "
           "failures=\"0\" tests=\"19\"/></testsuites>"
        << std::endl;
    return std::nullopt;
}

}  // namespace rt
