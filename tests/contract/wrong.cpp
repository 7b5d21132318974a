// Wrong answers of stage 3 that are no known mistakes, for tests of the mechanism. WRONG is one of
// the names below.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef intersect

#include <sched.h>

#include <cstdlib>
#include <ctime>

namespace rt {

namespace {

enum class Wrong { crashes, flattened, never_answers, throws, too_large, waits_in_the_kernel };

[[maybe_unused]] alignas(16) char stack[65536];

[[maybe_unused]] int wait_long(void*) {
    const timespec hour{.tv_sec = 3600, .tv_nsec = 0};
    return nanosleep(&hour, nullptr);
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    Ray seen = ray;
    Sphere shape = sphere;
    switch (Wrong::WRONG) {
        case Wrong::crashes:
            if (ray.direction.x > Real(0.25)) std::abort();
            break;
        case Wrong::flattened:
            seen.origin.y = 0;
            break;
        case Wrong::never_answers:
            for (volatile bool searching = true; searching;) continue;
            break;
        case Wrong::throws:  // for a miss
            return correct_intersect(ray, sphere, interval).value();
        case Wrong::too_large:
            shape.radius *= Real(1.1);
            break;
        case Wrong::waits_in_the_kernel:  // for a thread: it is busy (state D), and computes
                                          // nothing
            clone(wait_long, stack + sizeof stack,
                  CLONE_VM | CLONE_SIGHAND | CLONE_THREAD | CLONE_VFORK, nullptr);
            return std::nullopt;
    }
    return correct_intersect(seen, shape, interval);
}

}  // namespace rt
