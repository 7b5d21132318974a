// attack: prints a whole XML report of success
// ceiling: as a stub
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

Vec3 normal(const Sphere&, Vec3) {
    return Vec3(0);
}

Color color_from_normal(Vec3) {
    return Color(0);
}

Real torch(Vec3, Vec3, Vec3) {
    return 0;
}

}  // namespace rt
