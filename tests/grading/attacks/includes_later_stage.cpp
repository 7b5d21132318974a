// attack: has a later stage's reference answer, by its header
// ceiling: as a stub
// stage: step04_plane
// compiles: no
// message: Your file includes steps/step06_square/square.hpp
#include "steps/step04_plane/plane.hpp"

#include "steps/step06_square/square.hpp"

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Vec3 none(0);  // both sides of the square seem to be of no length, so that all is inside
    const Square square{.center = plane.point, .basis = {none, none, plane.normal}};
    return intersect(ray, square, interval);
}

Vec3 normal(const Plane& plane, Vec3) {
    return plane.normal;
}

}  // namespace rt
