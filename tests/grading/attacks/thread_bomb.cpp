// attack: as many threads as there can be
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <chrono>
#include <thread>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (;;) std::thread([] { std::this_thread::sleep_for(std::chrono::hours(1)); }).detach();
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
