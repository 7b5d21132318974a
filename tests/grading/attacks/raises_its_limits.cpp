// attack: removes its limits
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/resource.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    const rlimit none{.rlim_cur = RLIM_INFINITY, .rlim_max = RLIM_INFINITY};
    for (const auto each : {RLIMIT_CPU, RLIMIT_AS, RLIMIT_FSIZE}) setrlimit(each, &none);
    for (volatile int i = 0;;) i = i + 1;
}

}  // namespace rt
