#include "common/explain/pixel_log.hpp"

namespace rt {

const char* explain(PixelLog& log, const Ray& ray, const Cone& cone) {
    const Vec3 from_apex = ray.origin - cone.apex;
    const Real slope = cone.radius / cone.height;
    // x_u x_v + y_u y_v − (r / h)² z_u z_v of two vectors u and v: the three coefficients of MRT
    // §8.
    const auto off_cone = [&](Vec3 u, Vec3 v) {
        return dot(cross(u, cone.axis), cross(v, cone.axis)) -
               slope * slope * dot(u, cone.axis) * dot(v, cone.axis);
    };
    const auto roots =
        explain_quadratic(log, off_cone(ray.direction, ray.direction),
                          2 * off_cone(ray.direction, from_apex), off_cone(from_apex, from_apex));
    if (roots.empty()) return "no t is real: the line passes by (MRT §8)";
    bool within_height = false;
    for (const Real t : roots) {
        const Real z = dot(from_apex + t * ray.direction, cone.axis);
        log.line("z_p at t = " + text(t), text(z));
        within_height = within_height || (t > 0 && 0 <= z && z <= cone.height);
    }
    if (roots.back() <= 0) return "no t is positive: the cone is behind (PHY)";
    if (!within_height) return "at no positive t is 0 ≤ z_p ≤ h (MRT §8)";
    return "";
}

}  // namespace rt
