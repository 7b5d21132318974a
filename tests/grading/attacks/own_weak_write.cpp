// attack: replaces write and _exit by functions whose symbols are declared weak objects
// ceiling: as a stub
// compiles: perhaps
#include "steps/step03_sphere/sphere.hpp"

asm(R"(
    .text
    .weak write
    .type write, @object
write:
    .weak _exit
    .type _exit, @object
_exit:
    ret
)");

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
