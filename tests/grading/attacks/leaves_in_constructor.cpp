// attack: exits with status 0 before the first query
// ceiling: as a stub
// told: ended the program, with status 0
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

namespace {

const bool done = [] {
    std::_Exit(0);
    return true;
}();

}  // namespace

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
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
