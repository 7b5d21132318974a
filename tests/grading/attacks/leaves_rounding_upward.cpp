// attack: leaves the rounding mode upward, to mislead the comparison
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#include <cfenv>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    std::fesetround(FE_UPWARD);
    return std::nullopt;
}

Vec3 normal(const Sphere&, Vec3) {
    return Vec3(0);
}

Color color_from_normal(Vec3) {
    return Color(0);
}

Real torch(Vec3, Vec3, Vec3) {
    return 0;
}

}  // namespace rt
