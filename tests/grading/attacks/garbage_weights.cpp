// attack: answers with weights that are no numbers, which is right for a triangle without area
// ceiling: 6
// stage: step05_triangle
#include "steps/step05_triangle/triangle.hpp"

#include <limits>

namespace rt {

std::optional<Real> intersect(const Ray&, const Triangle&, Interval) {
    return std::nullopt;
}

Vec3 barycentric(const Triangle&, Vec3) {
    return Vec3(std::numeric_limits<Real>::quiet_NaN());
}

Vec3 normal(const Triangle&, Vec3) {
    return Vec3(0);
}

}  // namespace rt
