#include "steps/step12_mirror/mirror.hpp"

namespace rt {

namespace {

Vec3 reflected_at(Vec3 d, Vec3 n) {
    return d - 2 * dot(d, n) * n;
}

}  // namespace

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Vec3 direction = reflected_at(ray.direction, surface.normal);
    if (!(dot(direction, surface.geometric_normal) > 0))
        direction = reflected_at(ray.direction, surface.geometric_normal);
    return {.origin = surface.point + surface.error * surface.geometric_normal,
            .direction = direction};
}

Color mixed(Color own, Color reflection, Real mirror) {
    return (1 - mirror) * own + mirror * reflection;
}

bool worth_reflecting(int bounces, int depth, Real weight) {
    return bounces < depth && weight >= Real(1) / 512;
}

}  // namespace rt
