// attack: exits at a query, with status 0
// ceiling: as a stub
// stage: step05_triangle
#include "steps/step05_triangle/triangle.hpp"

#include <cstdlib>

namespace rt {

std::optional<Real> intersect(const Ray&, const Triangle&, Interval) {
    std::exit(0);
}

Vec3 barycentric(const Triangle&, Vec3) {
    return Vec3(0);
}

Vec3 normal(const Triangle&, Vec3) {
    return Vec3(0);
}

}  // namespace rt
