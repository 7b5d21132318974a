// attack: calls itself without end
// ceiling: as a stub
// told: crashed
#include "steps/step03_sphere/sphere.hpp"

namespace {

int deeper(volatile int* above) {
    volatile int here[1000] = {*above};
    return deeper(here) + here[1];
}

}  // namespace

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    volatile int start = 0;
    return deeper(&start);
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
