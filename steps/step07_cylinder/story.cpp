#include "common/explain/pixel_log.hpp"

#include <cmath>

namespace rt {

const char* explain(PixelLog& log, const Ray& ray, const Cylinder& cylinder) {
    // v ∧ Z has the length of the component of v in the plane of X and Y, for any choice of these.
    const Vec3 from_center = ray.origin - cylinder.center;
    const Vec3 o = cross(from_center, cylinder.axis);
    const Vec3 d = cross(ray.direction, cylinder.axis);
    const auto roots = explain_quadratic(log, dot(d, d), 2 * dot(o, d),
                                         dot(o, o) - cylinder.radius * cylinder.radius);
    if (dot(d, d) == 0) return "A = 0: the ray runs along the axis (MRT §7)";
    if (roots.empty()) return "Δ < 0, so no t is real: the line passes by (MRT §7)";
    bool within_height = false;
    for (const Real t : roots) {
        const Real z = dot(from_center + t * ray.direction, cylinder.axis);
        log.line("z_p at t = " + text(t), text(z));
        within_height = within_height || (t > 0 && std::abs(z) <= cylinder.height / 2);
    }
    if (roots.back() <= 0) return "no t is positive: the cylinder is behind (PHY)";
    if (!within_height) return "at no positive t is |z_p| ≤ h / 2 (MRT §7)";
    return "";
}

}  // namespace rt
