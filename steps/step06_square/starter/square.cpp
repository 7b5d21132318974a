// Stage 6, to be written: docs/step06_square.md.
#include "steps/step06_square/square.hpp"

#include "common/todo.hpp"

#include <cmath>

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    // The t strictly inside the interval at which the ray meets the square, or nothing.
    RT_TODO(ray, square, interval);
    return std::nullopt;
}

Vec2 square_uv(const Square& square, Vec3 point) {
    // 0 to 1 along the square's x and y, from its corner C.
    RT_TODO(square, point);
    return Vec2(0);
}

Vec3 normal(const Square& square, Vec3 point) {
    // The square's Z, at every point.
    RT_TODO(square, point);
    return Vec3(0);
}

}  // namespace rt
