// attack: is an object that a compiler would complete at the link
// ceiling: as a stub
// compiles: no
// told: LTO
// untold: nm:
#include "steps/step03_sphere/sphere.hpp"

asm(".section .gnu.lto_.profile.1, \"\"\n.byte 0\n.comm __gnu_lto_slim, 1");

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
