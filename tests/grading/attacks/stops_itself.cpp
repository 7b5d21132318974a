// attack: stops, by a signal to itself
// ceiling: as a stub
// message: gave no answer
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <csignal>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::raise(SIGSTOP);
    return std::nullopt;
}

}  // namespace rt
