// Stage 6, to be written. docs/step06_square.md explains it, the header is its contract.
// Begin with intersect. Until normal is written too, hits are magenta: not a number.
// square_uv does not affect a picture: only the suite calls it.
// `./course check 6` reports errors, `./course hint 6` prints the next hint.
#include "steps/step06_square/square.hpp"

#include "common/stages/todo.hpp"

#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    // The t strictly inside the interval at which the ray hits the square, or nothing.
    RT_TODO(ray, square, interval);
    return std::nullopt;
}

Vec2 square_uv(const Square& square, Vec3 point) {
    // 0 to 1 along the square's x and y, from its corner C.
    RT_TODO(square, point);
    return Vec2(0);
}

Vec3 normal(const Square& square, Vec3 /*point*/) {
    // The square's Z, at every point.
    RT_TODO(square);
    return Vec3(0);
}

}  // namespace rt
