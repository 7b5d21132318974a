// right: the part along the normal turned round, the part along the mirror kept
#include "steps/step12_mirror/mirror.hpp"

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Vec3 normal = surface.normal;
    for (int attempt = 0; attempt < 2; ++attempt, normal = surface.geometric_normal) {
        const Vec3 across = dot(ray.direction, normal) * normal;
        const Vec3 along = ray.direction - across;
        const Ray sent{.origin = surface.point + surface.geometric_normal * surface.error,
                       .direction = along - across};
        if (attempt == 1 || dot(sent.direction, surface.geometric_normal) > 0) return sent;
    }
    return ray;
}

Color mixed(Color own, Color reflection, Real mirror) {
    return own + mirror * (reflection - own);
}

bool worth_reflecting(int bounces, int depth, Real weight) {
    if (bounces >= depth) return false;
    if (weight < Real(1) / Real(512)) return false;
    return true;
}

}  // namespace rt
