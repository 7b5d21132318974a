// attack: has an assembler's error, which names a temporary file
// ceiling: as a stub
// compiles: no
// told: temporary.s
// untold: raysteps.
#include "steps/step03_sphere/sphere.hpp"

asm("no_such_instruction");

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
