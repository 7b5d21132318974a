// attack: an object of 4 GB
// ceiling: as a stub
// compiles: no
#include "steps/step03_sphere/sphere.hpp"

asm(".data\n.fill 4000000000, 1, 65\n.text");

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
