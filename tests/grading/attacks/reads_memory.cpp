// attack: reads the memory of the client
// ceiling: as a stub
// told: tried a forbidden operation
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
