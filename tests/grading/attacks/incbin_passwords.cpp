// attack: includes /etc/shadow by .incbin
// ceiling: as a stub
// compiles: no
// told: /etc/shadow
#include "steps/step03_sphere/sphere.hpp"

asm(".section .rodata\n.incbin \"/etc/shadow\"\n.text");

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
