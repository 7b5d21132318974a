// attack: reads the memory of the client by /proc
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <string>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (int process = 1; process < 40000; process += 7) {
        const std::string file = "/proc/" + std::to_string(process) + "/mem";
        if (open(file.c_str(), O_RDWR) != -1) return 1;
    }
    return std::nullopt;
}

}  // namespace rt
