// attack: leaves a daemon that rewrites the results later
// ceiling: as a stub
// told: tried a forbidden operation
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>
#include <fstream>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (fork() == 0) {
        setsid();
        sleep(2);
        std::ofstream("@RESULTS@") << "{\"points\": 100}\n";
        _exit(0);
    }
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
