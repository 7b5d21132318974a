// attack: tries to outlive its parent
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <sys/prctl.h>
#include <unistd.h>
#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    prctl(PR_SET_PDEATHSIG, 0);
    for (;;) sleep(1000);
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
