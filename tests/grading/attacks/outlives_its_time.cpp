// attack: ignores the signal at the end of its time
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::signal(SIGXCPU, SIG_IGN);
    for (volatile int i = 0;;) i = i + 1;
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
