// attack: leaves denormal numbers as zeros
// ceiling: as a stub
#include "steps/step03_sphere/sphere.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
#if defined(__x86_64__)
    _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
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
