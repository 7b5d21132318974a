// Waits for a thread without being asleep: the kernel calls it busy (state D), and it computes
// nothing.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

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
