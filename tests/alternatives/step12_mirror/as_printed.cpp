// right: CR's equation 4; a ray into the surface is reflected once more
#include "steps/step12_mirror/mirror.hpp"

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 n = surface.normal;
    Vec3 direction = ray.direction - (Real(2) * n * dot(ray.direction, n));
    if (dot(direction, surface.geometric_normal) <= 0)
        direction = direction -
                    (Real(2) * surface.geometric_normal * dot(direction, surface.geometric_normal));
    return {.origin = surface.point + Real(2) * surface.error * surface.geometric_normal,
            .direction = direction};
}

Color mixed(Color own, Color reflection, Real mirror) {
    return mix(own, reflection, mirror);
}

bool worth_reflecting(int bounces, int depth, Real weight) {
    const int remaining = depth - bounces;
    if (remaining <= 0) return false;
    return 512 * weight >= 1;
}

}  // namespace rt
