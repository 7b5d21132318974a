#include "common/explain/pixel_log.hpp"

namespace rt {

const char* explain(PixelLog& log, const Ray& ray, const Sphere& sphere) {
    const Vec3 from_center = ray.origin - sphere.center;
    log.line("r_s0 = o_r − o", text(from_center));
    const auto roots = explain_quadratic(
        log, dot(ray.direction, ray.direction), 2 * dot(from_center, ray.direction),
        dot(from_center, from_center) - sphere.radius * sphere.radius);
    if (roots.empty()) return "Δ < 0, so no t is real: the line passes by (PHY)";
    if (roots.back() <= 0) return "no t is positive: the sphere is behind (PHY)";
    return "";
}

}  // namespace rt
