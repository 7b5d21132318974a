// attack: a process by clone, past the library
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0) == 0) sleep(100);
    return std::nullopt;
}

}  // namespace rt
