// attack: leaves a daemon that rewrites the results later
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>
#include <fstream>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (fork() == 0) {
        setsid();
        sleep(2);
        std::ofstream("@RESULTS@") << "{\"points\": 100}\n";
        _exit(0);
    }
    return std::nullopt;
}

}  // namespace rt
