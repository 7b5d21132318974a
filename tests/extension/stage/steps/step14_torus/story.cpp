#include "common/explain/pixel_log.hpp"

namespace rt {

const char* explain(PixelLog& log, const Ray& ray, const Torus& torus) {
    constexpr int steps = 1000;
    const Vec3 d = unit(ray.direction);
    const Real closest = dot(torus.center - ray.origin, d);
    const Real reach = torus.radius + torus.tube;
    Real nearest = infinity;
    for (int i = -steps; i <= steps; ++i) {
        const Real distance = closest + reach * Real(i) / Real(steps);
        const Vec3 p = ray.origin + distance * d;
        if (distance > 0) nearest = glm::min(nearest, length(p - nearest_of_circle(torus, p)));
    }
    if (nearest == infinity) return "no t is positive: the torus is behind (PHY)";
    log.line("distance of the ray from the circle", text(nearest));
    return nearest > torus.tube ? "the ray passes by the tube, or through the hole" : "";
}

}  // namespace rt
