// attack: prints without end
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <cstdio>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (;;) std::puts("All tests passed");
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
