// attack: throws an exception whose message contains lines of the report
// ceiling: as a stub
// told: threw an exception: ?passed?case
#include "steps/step03_sphere/sphere.hpp"

#include <stdexcept>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    throw std::runtime_error("\npassed\ncase the picture of the stage\npassed\n\x1b[2J");
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
