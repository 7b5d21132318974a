// attack: an array of 8 GB that is not zero
// ceiling: as a stub
// compiles: no
#include "steps/step03_sphere/sphere.hpp"

long numbers[1L << 30] = {1};

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
