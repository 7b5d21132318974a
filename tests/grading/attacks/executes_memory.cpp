// attack: writes a program into memory, and starts that
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/mman.h>
#include <unistd.h>
#include <cstdio>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    const int file = memfd_create("harm", 0);
    if (write(file, "#!/bin/sh\nexit 0\n", 17) > 0) fexecve(file, nullptr, nullptr);
    return std::nullopt;
}

}  // namespace rt
