// attack: closes the channel, and goes on computing
// ceiling: as a stub
// told: closed the channel
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    close(3);
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
