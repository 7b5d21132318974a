// attack: throws an exception with a message of 40 MB
// ceiling: as a stub
// message: threw an exception: <<<
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <stdexcept>
#include <string>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    throw std::runtime_error(std::string(40000000, '<'));
}

}  // namespace rt
