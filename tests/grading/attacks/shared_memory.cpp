// attack: makes memory that others see
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/ipc.h>
#include <sys/shm.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    shmget(IPC_PRIVATE, 4096, IPC_CREAT);
    return std::nullopt;
}

}  // namespace rt
