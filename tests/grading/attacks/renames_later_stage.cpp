// attack: calls a later stage's reference by its symbol, under a name of its own
// ceiling: as a stub
// stage: step04_plane
// compiles: no
// message: Your file calls rt::intersect(
#include "steps/step04_plane/plane.hpp"

// As in common/geometry/square.hpp, which may not be included.
namespace rt {
inline namespace RT_PRECISION {

struct Square {
    Vec3 center;
    Basis basis;
    Real side = 1;
    bool one_sided = false;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

std::optional<Real> other(const Ray&, const Square&, Interval) asm(
    "_ZN2rt9intersectERKNS_3f643RayERKNS0_6SquareENS0_8IntervalE");

}  // namespace rt

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const Vec3 none(0);  // both sides of the square seem to be of no length, so that all is inside
    const Square square{.center = plane.point, .basis = {none, none, plane.normal}};
    return other(ray, square, interval);
}

Vec3 normal(const Plane& plane, Vec3) {
    return plane.normal;
}

}  // namespace rt
