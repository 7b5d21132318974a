// attack: goes past the filter, by io_uring
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    char parameters[256] = {};
    syscall(SYS_io_uring_setup, 8, parameters);
    return std::nullopt;
}

}  // namespace rt
