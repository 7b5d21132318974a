// attack: leaves a thread that sleeps, in a process whose first thread has ended
// ceiling: as a stub
// message: gave no answer
// stubs: normal color_from_normal torch
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

}  // namespace rt
