// attack: writes its own results
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <fstream>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::ofstream("@RESULTS@") << "{\"points\": 100}\n";
    return std::nullopt;
}

}  // namespace rt
