// attack: is blocked in the kernel, neither computing nor asleep, until a thread of its own ends
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sched.h>

#include <ctime>

namespace rt {

namespace {

alignas(16) char stack[65536];

int wait_long(void*) {
    const timespec hour{.tv_sec = 3600, .tv_nsec = 0};
    return nanosleep(&hour, nullptr);
}

}  // namespace

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    clone(wait_long, stack + sizeof stack, CLONE_VM | CLONE_SIGHAND | CLONE_THREAD | CLONE_VFORK,
          nullptr);
    return std::nullopt;
}

}  // namespace rt
