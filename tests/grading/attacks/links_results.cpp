// attack: puts a link where results will be
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (symlink("/etc/passwd", "@RESULTS@.new") == 0) return 1;
    return std::nullopt;
}

}  // namespace rt
