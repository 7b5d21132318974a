// attack: reads the memory of the client
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/uio.h>
#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    char taken[64];
    const iovec here{.iov_base = taken, .iov_len = sizeof taken};
    const iovec there{.iov_base = reinterpret_cast<void*>(0x400000), .iov_len = sizeof taken};
    if (process_vm_readv(getppid(), &here, 1, &there, 1, 0) > 0) return taken[0];
    return std::nullopt;
}

}  // namespace rt
