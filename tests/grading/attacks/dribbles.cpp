// attack: floods the channel with zeros
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    const char zeros[65536] = {};
    while (write(3, zeros, sizeof zeros) > 0) continue;
    return 1;
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
