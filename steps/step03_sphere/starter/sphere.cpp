// Stage 3, to be written. docs/step03_sphere.md explains it, the header is its contract.
// Begin with intersect. Until normal is written too, hits are magenta: not a number.
// `./course check 3` reports errors, `./course hint 3` prints the next hint.
#include "steps/step03_sphere/sphere.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    // The smallest t strictly inside the interval, or nothing.
    RT_TODO(ray, sphere, interval);
    return std::nullopt;
}

Vec3 normal(const Sphere& sphere, Vec3 point) {
    // Away from the center, with unit length.
    RT_TODO(sphere, point);
    return Vec3(0);
}

Color color_from_normal(Vec3 normal) {
    // |x|, |y|, |z| of the unit normal.
    RT_TODO(normal);
    return Color(0);
}

Real torch(Vec3 point, Vec3 normal, Vec3 eye) {
    // cos θ between the normal and the direction to the eye, or 0.
    RT_TODO(point, normal, eye);
    return 0;
}

}  // namespace rt
