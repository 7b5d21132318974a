// attack: defines functions of the worker
// ceiling: as a stub
// compiles: no
// told: say_todo
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

void say_todo(const char*, int, const char*) {}

}  // namespace rt

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
