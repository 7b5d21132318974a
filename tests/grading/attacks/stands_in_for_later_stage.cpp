// attack: defines a later stage's function weakly: the reference would go first
// ceiling: as a stub
// stage: step04_plane
// compiles: no
// message: which is not the stage's
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

[[gnu::weak, gnu::noinline]] std::optional<Real> intersect(const Ray&, const Square&, Interval) {
    return std::nullopt;
}

}  // namespace rt

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
