// attack: includes the reference if it is there
// ceiling: as a stub
// compiles: perhaps
#include "steps/step03_sphere/sphere.hpp"

#if __has_include("@ROOT@/steps/step03_sphere/reference/sphere.cpp")
#include "@ROOT@/steps/step03_sphere/reference/sphere.cpp"
#else
namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
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
#endif
