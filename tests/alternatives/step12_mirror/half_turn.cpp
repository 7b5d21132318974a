// right: the direction to the eye rotated by 180° around the normal, by a matrix, and as long as d
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
