// attack: brings a function of another stage too, for which it needs no header
// ceiling: as a stub
// compiles: no
// told: which is not the stage's
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

Vec3 normal(const Plane&, Vec3) {
    return Vec3(0);
}

}  // namespace rt
