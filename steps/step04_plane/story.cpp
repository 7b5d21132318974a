#include "common/explain/pixel_log.hpp"

namespace rt {

const char* explain(PixelLog& log, const Ray& ray, const Plane& plane) {
    const Real distance = dot(plane.point - ray.origin, plane.normal);
    const Real approach = dot(ray.direction, plane.normal);
    log.line("⟨o − o_r, n⟩", text(distance));
    log.line("⟨d_r, n⟩", text(approach));
    if (approach == 0) return "⟨d_r, n⟩ = 0: the ray is parallel to the plane (MRT §4)";
    log.line("t", text(distance / approach));
    if (distance / approach <= 0) return "t is not positive: the plane is behind (MRT §4)";
    return "";
}

}  // namespace rt
