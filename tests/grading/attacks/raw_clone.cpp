// attack: a process by clone, past the library
// ceiling: as a stub
// told: tried a forbidden operation
#include "steps/step03_sphere/sphere.hpp"

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0) == 0) sleep(100);
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
