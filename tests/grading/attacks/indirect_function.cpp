// attack: lets the loader call it, by an indirect function
// ceiling: as a stub
// compiles: no
// told: indirect function
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

extern "C" {
static void (*resolve())() {
    std::_Exit(0);
}
}
namespace rt {

void early() __attribute__((ifunc("resolve")));

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
