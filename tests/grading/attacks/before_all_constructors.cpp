// attack: exits from .preinit_array
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

namespace {

[[gnu::used, gnu::section(".preinit_array")]] void (*const first)() = [] { std::_Exit(0); };

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
