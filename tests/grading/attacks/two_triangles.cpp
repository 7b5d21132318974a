// attack: a square of two triangles, intersected by stage 5's reference, not on its page's list
// ceiling: as a stub
// stage: step06_square
// compiles: no
// message: Your file calls rt::intersect(
#include "steps/step06_square/square.hpp"

// As in common/geometry/triangle.hpp, which may not be included.
namespace rt {
inline namespace RT_PRECISION {

struct Triangle {
    Vec3 a;
    Vec3 b;
    Vec3 c;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

std::optional<Real> intersect(const Ray&, const Triangle&, Interval);

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    const Vec3 x = square.side / 2 * square.basis.x;
    const Vec3 y = square.side / 2 * square.basis.y;
    const Vec3 o = square.center;
    const Triangle lower{.a = o - x - y, .b = o + x - y, .c = o + x + y};
    const Triangle upper{.a = o - x - y, .b = o + x + y, .c = o - x + y};
    if (const auto t = intersect(ray, lower, interval)) return t;
    return intersect(ray, upper, interval);
}

Vec2 square_uv(const Square&, Vec3) {
    return Vec2(0);
}

Vec3 normal(const Square& square, Vec3) {
    return square.basis.z;
}

}  // namespace rt
