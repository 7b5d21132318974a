// right as_printed: CR's equation 4; a ray into the surface is reflected once more
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

// right by_parts: the part along the normal turned round, the part along the mirror kept
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

// right half_turn: the direction to the eye rotated by 180° around the normal, by a matrix, and as
// long as d
#include "steps/step12_mirror/mirror.hpp"

#include "common/math/vector.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace rt {

namespace {

/// 2 n nᵀ − 1: half a turn about n.
Vec3 turned_about(Vec3 n, Vec3 v) {
    return Real(2) * glm::outerProduct(n, n) * v - v;
}

}  // namespace

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Vec3 direction = turned_about(surface.normal, surface.to_eye);
    if (!(dot(direction, surface.geometric_normal) > 0))
        direction = turned_about(surface.geometric_normal, surface.to_eye);
    return {.origin = surface.point + Real(1.5) * surface.error * surface.geometric_normal,
            .direction = length(ray.direction) * direction};
}

Color mixed(Color own, Color reflection, Real mirror) {
    Color sum(0);
    for (int i = 0; i < 3; ++i) sum[i] = own[i] * (1 - mirror) + reflection[i] * mirror;
    return sum;
}

bool worth_reflecting(int bounces, int depth, Real weight) {
    return !(weight < Real(1) / 512) && bounces + 1 <= depth;
}

}  // namespace rt
