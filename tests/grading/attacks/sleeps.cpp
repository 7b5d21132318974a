// attack: sleeps
// ceiling: as a stub
// told: no answer within 1 s
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
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
