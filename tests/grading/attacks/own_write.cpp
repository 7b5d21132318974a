// attack: replaces write, which main uses to answer
// ceiling: as a stub
// compiles: no
// told: defines write
#include "steps/step03_sphere/sphere.hpp"

#include <sys/types.h>

extern "C" ssize_t write(int, const void*, size_t size) {
    return ssize_t(size);
}

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
