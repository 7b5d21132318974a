// attack: leaves a thread that sleeps, in a process whose first thread has ended
// ceiling: as a stub
// told: gave no answer
#include "steps/step03_sphere/sphere.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::thread([] { std::this_thread::sleep_for(std::chrono::hours(1)); }).detach();
    syscall(SYS_exit, 0);
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
