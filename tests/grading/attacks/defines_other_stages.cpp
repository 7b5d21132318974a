// attack: brings functions of other stages too
// ceiling: as a stub
// compiles: no
// message: Your file includes steps/step04_plane/plane.hpp
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include "steps/step04_plane/plane.hpp"

namespace rt {

Vec3 normal(const Plane&, Vec3) {
    return Vec3(0);
}

}  // namespace rt
