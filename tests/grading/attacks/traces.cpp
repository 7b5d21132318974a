// attack: traces its parent
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/ptrace.h>
#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr);
    return std::nullopt;
}

}  // namespace rt
