// attack: exits with status 0 after a crash
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>
#include <exception>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::set_terminate([] { std::_Exit(0); });
    std::terminate();
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
