// attack: starts a shell by system
// ceiling: as a stub
// told: tried a forbidden operation
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (std::system("echo harm >> @RESULTS@") == 0) return 1;
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
