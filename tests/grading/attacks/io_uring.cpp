// attack: goes past the filter, by io_uring
// ceiling: as a stub
// told: tried a forbidden operation
#include "steps/step03_sphere/sphere.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    char parameters[256] = {};
    syscall(SYS_io_uring_setup, 8, parameters);
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
